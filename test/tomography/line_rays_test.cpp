#include "tomography/line_rays.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sfw {
namespace {

const std::vector<LineLattice> kTwo{{GridGeometry(1.0, {0.0, 0.0}, 3, 2)},
                                    {GridGeometry(1.0, {0.0, 0.0}, 2, 4), 0.5}};

/// "lattice, direction, cell" of each unknown, in their order.
std::vector<std::string> described(const Unknowns& unknowns) {
  std::vector<std::string> texts;
  unknowns.forEach([&](Eigen::Index i, const Unknowns::Direction& direction, Cell c) {
    EXPECT_EQ(static_cast<std::size_t>(i), texts.size());
    texts.push_back(std::to_string(direction.lattice) + (direction.walls_along_y ? "x" : "y") +
                    std::to_string(c.x) + std::to_string(c.y));
  });
  return texts;
}

TEST(Unknowns, AreNumberedAlongTheirWalls) {
  Unknowns unknowns(kTwo);
  const auto add = [&](std::size_t lattice, bool walls_along_y, Cell c) {
    unknowns.add(unknowns.slot({lattice, walls_along_y}, c));
  };
  add(1, false, {1, 3});
  add(0, true, {2, 1});
  add(0, true, {2, 0});
  add(0, false, {0, 1});
  add(0, false, {1, 1});
  add(1, true, {0, 0});
  add(0, true, {1, 1});
  unknowns.number();
  EXPECT_EQ(described(unknowns),
            (std::vector<std::string>{"0x11", "0x20", "0x21", "0y01", "0y11", "1x00", "1y13"}));
  // 0x20 stands in the slot behind 0x11, but on the next line.
  const Eigen::ArrayXf continued = unknowns.continued();
  EXPECT_EQ(std::vector<float>(continued.data(), continued.data() + continued.size()),
            (std::vector<float>{0, 1, 0, 1, 0, 0}));
  EXPECT_EQ(unknowns.in(unknowns.slot({0, true}, {2, 1})), 2);
  EXPECT_EQ(unknowns.in(unknowns.slot({0, true}, {0, 1})), Unknowns::kNone);
}

TEST(Unknowns, MayBeNone) {
  Unknowns unknowns(kTwo);
  unknowns.number();
  EXPECT_EQ(unknowns.size(), 0U);
  EXPECT_EQ(unknowns.continued().size(), 0);
}

TEST(Rays, CrossWhatStandsBetweenAccessPointAndBins) {
  AccessPointBins access_point;
  access_point.position = {0.2, 0.2};
  access_point.bins = {{{2.8, 0.3}, -40.0, 1.0}, {{0.8, 0.3}, -40.0, 1.0}};
  Mask driven(kTwo[0].geometry);
  driven[{1, 0}] = 1;
  const std::atomic<bool> never{false};
  const Rays rays({kTwo[0]}, {access_point}, {driven}, never);
  EXPECT_EQ(rays.size(), 2U);
  EXPECT_EQ(described(rays.unknowns()), (std::vector<std::string>{"0x00", "0x20"}));
  Eigen::VectorXf sums;
  rays.along(Eigen::Vector2f(3.0F, 5.0F), sums);
  EXPECT_EQ(sums, Eigen::Vector2f(8.0F, 3.0F));
  rays.spread(Eigen::Vector2f(1.0F, 10.0F), sums);
  EXPECT_EQ(sums, Eigen::Vector2f(11.0F, 1.0F));
}

}  // namespace
}  // namespace sfw
