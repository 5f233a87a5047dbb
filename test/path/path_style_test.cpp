#include "path/path_style.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "support/ascii_world.h"

namespace sfw::test {
namespace {

constexpr double kMaxGap = 1.2;  // [m]
const GridGeometry kNoCells(1.0, {0.0, 0.0}, 1, 1);

/// Style of a way, whatever it encloses.
PathStyle styleOfWay(const std::vector<Position>& driven) {
  return measurePathStyle(Mask(kNoCells), Grid<float>(kNoCells), driven, kMaxGap);
}

// ---- Rim share ----

TEST(PathStyle, RimShareCountsCellsWithinFifteenCentimetresOfTheRim) {
  const Mask path = mask({"####.."});
  Grid<float> depth(path.geometry);
  depth.cells = {0.10F, 0.15F, 0.16F, 1.2F, 0.0F, -0.5F};
  EXPECT_EQ(measurePathStyle(path, depth, {{0.0, 0.0}}, kMaxGap).rim_share, 0.5);
}

TEST(PathStyle, RimShareOfNoCellsIsZero) { EXPECT_EQ(styleOfWay({{0.0, 0.0}}).rim_share, 0.0); }

// ---- Axis share: the mean cosine of four times the heading ----

TEST(PathStyle, AxisShareIsOneAlongTheAxesAndMinusOneMidway) {
  EXPECT_NEAR(styleOfWay({{0, 0}, {1, 0}}).axis_share, 1.0, 1e-9);
  EXPECT_NEAR(styleOfWay({{0, 0}, {0, -1}}).axis_share, 1.0, 1e-9);
  EXPECT_NEAR(styleOfWay({{0, 0}, {0.5, 0.5}}).axis_share, -1.0, 1e-9);
  EXPECT_NEAR(styleOfWay({{0, 0}, {-0.5, 0.5}}).axis_share, -1.0, 1e-9);
  const double eighth = std::tan(kPi / 8.0);
  EXPECT_NEAR(styleOfWay({{0, 0}, {1, eighth}}).axis_share, 0.0, 1e-9);
}

TEST(PathStyle, AxisShareWeighsPiecesByTheirLength) {
  // One metre along an axis, half a metre midway: (1 - 0.5) / 1.5.
  const double step = 0.5 * std::sqrt(0.5);
  EXPECT_NEAR(styleOfWay({{0, 0}, {1, 0}, {1 + step, step}}).axis_share, 1.0 / 3.0, 1e-9);
}

TEST(PathStyle, AxisShareTakesNoHeadingFromStepsBelowTenCentimetres) {
  // The jitter of a pose on the way along x: the step of 0.03 m to the side is no piece.
  EXPECT_NEAR(styleOfWay({{0, 0}, {0.5, 0}, {0.5, 0.03}, {1.0, 0.0}}).axis_share, 1.0, 1e-9);
}

TEST(PathStyle, AxisShareTakesNoHeadingFromAJump) {
  EXPECT_NEAR(styleOfWay({{0, 0}, {1, 0}, {5, 4}, {6, 4}}).axis_share, 1.0, 1e-9);
}

TEST(PathStyle, AxisShareOfARobotAtRestIsZero) {
  EXPECT_EQ(styleOfWay({{0, 0}, {0.01, 0}}).axis_share, 0.0);
}

// ---- Winding: the mean of (1 - cosine) / 2 of turns ----

TEST(PathStyle, WindingIsZeroStraightOnAndOneThereAndBack) {
  EXPECT_NEAR(styleOfWay({{0, 0}, {0.4, 0}, {0.8, 0}}).winding, 0.0, 1e-9);
  EXPECT_NEAR(styleOfWay({{0, 0}, {0.4, 0}, {0, 0}}).winding, 1.0, 1e-9);
}

TEST(PathStyle, WindingIsTheMeanOfAllTurns) {
  // Straight on, then a right angle: (0 + 1/2) / 2.
  EXPECT_NEAR(styleOfWay({{0, 0}, {0.4, 0}, {0.8, 0}, {0.8, 0.4}}).winding, 0.25, 1e-9);
}

TEST(PathStyle, WindingIsThatOfPiecesOfThirtyCentimetres) {
  // Zigzags of 0.1 m that lead straight on. Pieces of one step would give 0.038.
  std::vector<Position> zigzag;
  for (int i = 0; i < 20; ++i) {
    zigzag.emplace_back(0.1 * i, i % 2 == 0 ? 0.0 : 0.02);
  }
  EXPECT_NEAR(styleOfWay(zigzag).winding, 0.0, 0.01);
}

TEST(PathStyle, WindingCountsNoTurnAcrossAJump) {
  EXPECT_EQ(styleOfWay({{0, 0}, {0.4, 0}, {3, 0}, {3, 0.4}}).winding, 0.0);
}

// ---- Alignment along the way ----

TEST(AxisAlignment, IsTheMeanOverSeventyFiveCentimetresToEachSide) {
  // Cells of half a metre: three pieces to the right, then two of 0.707 m midway between the axes.
  const GridGeometry geometry(0.5, {0.0, 0.0}, 7, 7);
  std::vector<Position> driven;
  for (const Cell c : {Cell{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 1}, {5, 2}}) {
    driven.push_back(geometry.centre(c));
  }
  const Grid<float> alignment = axisAlignment(geometry, driven, kMaxGap);
  const double half = 0.5;
  const double slanted = std::sqrt(0.5);
  // Of the third and the fourth piece, with their neighbours on both sides.
  const double third = (2 * half - slanted) / (2 * half + slanted);
  const double fourth = (half - 2 * slanted) / (half + 2 * slanted);
  EXPECT_NEAR((alignment[{0, 0}]), 1.0, 1e-6);
  EXPECT_NEAR((alignment[{1, 0}]), 1.0, 1e-6);
  EXPECT_NEAR((alignment[{2, 0}]), (1.0 + third) / 2.0, 1e-6) << "the second and the third piece";
  EXPECT_NEAR((alignment[{3, 0}]), (third + fourth) / 2.0, 1e-6);
  EXPECT_NEAR((alignment[{4, 1}]), (fourth - 1.0) / 2.0, 1e-6);
  EXPECT_NEAR((alignment[{5, 2}]), -1.0, 1e-6);
  EXPECT_EQ((alignment[{6, 6}]), 0.0F) << "off the way";
}

TEST(AxisAlignment, DoesNotReachAcrossAJump) {
  const GridGeometry geometry(0.5, {0.0, 0.0}, 7, 7);
  std::vector<Position> driven;
  for (const Cell c : {Cell{0, 0}, {1, 0}, {5, 5}, {6, 6}}) {
    driven.push_back(geometry.centre(c));
  }
  const Grid<float> alignment = axisAlignment(geometry, driven, kMaxGap);
  EXPECT_NEAR((alignment[{1, 0}]), 1.0, 1e-6);
  EXPECT_NEAR((alignment[{5, 5}]), -1.0, 1e-6);
  EXPECT_EQ((alignment[{3, 3}]), 0.0F) << "nobody drove there";
}

}  // namespace
}  // namespace sfw::test
