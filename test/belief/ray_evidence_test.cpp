#include "belief/ray_evidence.h"

#include <gtest/gtest.h>

#include "support/ascii_world.h"

namespace sfw::test {
namespace {

using Rows = std::vector<std::string>;

const std::atomic<bool> kNever{false};
const GridGeometry kSquare(1.0, {0.0, 0.0}, 7, 7);

AccessPointBins accessPoint(Cell at, const std::vector<Cell>& bins) {
  AccessPointBins access_point;
  access_point.position = kSquare.centre(at);
  for (const Cell bin : bins) {
    access_point.bins.push_back({kSquare.centre(bin), -50.0, 1.0});
  }
  return access_point;
}

/// A digit for each cell, '.' for none.
Rows picture(const Grid<float>& values) {
  return rowsOf(values, [](float value) {
    return value == 0.0F || value == RayEvidence::kUnseen ? '.' : static_cast<char>('0' + value);
  });
}

/// At the lower left with bins at the lower right and the upper right, and at the upper left with
/// bins in the middle of the right side and at the lower right. Rays lose 1, 2, 3 and 4 dB.
RayEvidence twoAccessPoints() {
  return rayEvidence(kSquare,
                     {accessPoint({0, 0}, {{6, 0}, {6, 6}}), accessPoint({0, 6}, {{6, 6}, {6, 0}})},
                     {{1.0, 2.0}, {3.0, 4.0}}, kNever);
}

TEST(RayEvidence, CountsTheRaysThroughEachCell) {
  EXPECT_EQ(picture(twoAccessPoints().rays), (Rows{"2111112",  //
                                                   ".1...1.",  //
                                                   "..1.1..",  //
                                                   "...2...",  //
                                                   "..1.1..",  //
                                                   ".1...1.",  //
                                                   "2111112"}));
}

TEST(RayEvidence, CountsTheAccessPointsOfThoseRays) {
  EXPECT_EQ(picture(twoAccessPoints().access_points), (Rows{"1111112",  //
                                                            ".1...1.",  //
                                                            "..1.1..",  //
                                                            "...2...",  //
                                                            "..1.1..",  //
                                                            ".1...1.",  //
                                                            "1111112"}));
}

TEST(RayEvidence, KeepsTheLeastLossOfAnyRay) {
  EXPECT_EQ(picture(twoAccessPoints().least_loss), (Rows{"3333332",  //
                                                         ".4...2.",  //
                                                         "..4.2..",  //
                                                         "...2...",  //
                                                         "..2.4..",  //
                                                         ".2...4.",  //
                                                         "1111111"}));
  EXPECT_EQ((twoAccessPoints().least_loss[{0, 3}]), RayEvidence::kUnseen);
}

TEST(RayEvidence, IsOfCellsOnTheGridOnly) {
  AccessPointBins outside = accessPoint({0, 3}, {{6, 3}});
  outside.position.x() -= 5.0;
  outside.bins.front().position.x() += 5.0;
  EXPECT_EQ(picture(rayEvidence(kSquare, {outside}, {{5.0}}, kNever).least_loss)[3], "5555555");
}

TEST(RayEvidence, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  const RayEvidence evidence = rayEvidence(kSquare, {accessPoint({0, 3}, {{6, 3}})}, {{5.0}}, stop);
  EXPECT_EQ(evidence.rays.cells, Grid<float>(kSquare).cells);
}

}  // namespace
}  // namespace sfw::test
