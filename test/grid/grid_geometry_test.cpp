#include "structure_from_wifi/grid_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

namespace sfw {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t kPlenty = 1'000'000'000;

/// What an action complains of.
std::string complaintOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

TEST(GridGeometry, RoundsDownOnBothSidesOfTheOrigin) {
  const GridGeometry grid(0.5, {-1.0, 2.0}, 4, 3);
  EXPECT_EQ(grid.cellAt({-1.0, 2.0}), (Cell{0, 0}));
  EXPECT_EQ(grid.cellAt({-0.51, 2.49}), (Cell{0, 0}));
  EXPECT_EQ(grid.cellAt({-0.5, 2.5}), (Cell{1, 1}));
  EXPECT_EQ(grid.cellAt({-1.01, 1.99}), (Cell{-1, -1}));
  EXPECT_EQ(grid.cellAt({-1.5, 1.5}), (Cell{-1, -1}));
  EXPECT_EQ(grid.cellAt({-1.51, 1.49}), (Cell{-2, -2}));
}

TEST(GridGeometry, EndsBeforeItsFarEdges) {
  const GridGeometry grid(0.5, {-1.0, 2.0}, 4, 3);
  EXPECT_EQ(grid.box().max(), Position(1.0, 3.5));
  EXPECT_FALSE(grid.contains(grid.cellAt({1.0, 2.0})));
  EXPECT_FALSE(grid.contains(grid.cellAt({-1.0, 3.5})));
  EXPECT_TRUE(grid.contains(grid.cellAt({1.0 - 1e-12, 3.5 - 1e-12})));
  EXPECT_FALSE(grid.contains({-1, 0}));
  EXPECT_FALSE(grid.contains({0, -1}));
}

TEST(GridGeometry, CentresLieInTheirCells) {
  const GridGeometry grid(0.05, {-3.7, 11.15}, 70, 50);
  for (std::int64_t y = -5; y < 55; ++y) {
    for (std::int64_t x = -5; x < 75; ++x) {
      ASSERT_EQ(grid.cellAt(grid.centre({x, y})), (Cell{x, y}));
    }
  }
}

TEST(GridGeometry, IndexesRowByRow) {
  const GridGeometry grid(1.0, {0, 0}, 3, 2);
  EXPECT_EQ(grid.size(), 6U);
  EXPECT_EQ(grid.index({0, 0}), 0U);
  EXPECT_EQ(grid.index({2, 0}), 2U);
  EXPECT_EQ(grid.index({0, 1}), 3U);
}

TEST(GridGeometry, NamesWhatItRefuses) {
  for (const double bad : {0.0, -0.05, kNaN, kInfinity}) {
    EXPECT_NE(complaintOf([&] {
                GridGeometry(bad, {0, 0}, 1, 1);
              }).find("resolution_m"),
              std::string::npos)
        << bad;
  }
  EXPECT_NE(complaintOf([] {
              GridGeometry(1.0, {kNaN, 0}, 1, 1);
            }).find("origin"),
            std::string::npos);
  EXPECT_NE(complaintOf([] {
              GridGeometry(1.0, {0, -kInfinity}, 1, 1);
            }).find("origin"),
            std::string::npos);
  for (const std::int64_t bad :
       {std::int64_t{0}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_NE(complaintOf([&] {
                GridGeometry(1.0, {0, 0}, bad, 1);
              }).find("width"),
              std::string::npos);
    EXPECT_NE(complaintOf([&] {
                GridGeometry(1.0, {0, 0}, 1, bad);
              }).find("height"),
              std::string::npos);
  }
}

TEST(Covering, TakesWholeStepsCountedFromTheFramesOrigin) {
  const auto grid =
      GridGeometry::covering({Position(-0.1, 3.9), Position(4.1, 4.1)}, 0.5, 2.0, 400);
  EXPECT_EQ(grid, GridGeometry(0.5, {-2.0, 2.0}, 16, 8));
}

TEST(Covering, HoldsTheBoxsFarCornerEvenOnAStep) {
  const auto grid = GridGeometry::covering({Position(0, 0), Position(2, 4)}, 0.5, 2.0, 400);
  EXPECT_EQ(grid, GridGeometry(0.5, {0.0, 0.0}, 8, 12));
}

TEST(Covering, RoundsStepsToCells) {
  const Box box{Position(0.1, 0.1), Position(0.2, 0.2)};
  EXPECT_EQ(GridGeometry::covering(box, 0.3, 1.0, 100).width(), 3);
  EXPECT_EQ(GridGeometry::covering(box, 0.3, 0.01, 100).width(), 1);
}

TEST(Covering, HoldsItsBoxAndFitsTheLatticeForAnyBox) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-300.0, 300.0);
  for (const double resolution : {0.05, 0.1, 0.03, 0.25}) {
    for (int i = 0; i < 2000; ++i) {
      Box box(Position(coordinate(random), coordinate(random)));
      box.extend(Position(coordinate(random), coordinate(random)));
      if (i % 2 == 0) {  // corners on the lattice, the hard case
        box.min() = (box.min() / resolution).array().round() * resolution;
        box.max() = (box.max() / resolution).array().round() * resolution;
      }
      const auto grid = GridGeometry::covering(box, resolution, 0.8, kPlenty);
      ASSERT_TRUE(grid.contains(grid.cellAt(box.min()))) << box.min();
      ASSERT_TRUE(grid.contains(grid.cellAt(box.max()))) << box.max();
      const Position in_cells = grid.origin() / resolution;
      ASSERT_NEAR((in_cells - Position(in_cells.array().round())).norm(), 0.0, 1e-9);
    }
  }
}

TEST(Covering, DependsOnTheBoxAloneNotOnHowItGrew) {
  const std::vector<Position> points{{0.3, 0.4}, {-7.7, 2.0}, {31.0, -12.4}, {2.0, 19.9}};
  Box forward;
  Box backward;
  for (std::size_t i = 0; i < points.size(); ++i) {
    forward.extend(points[i]);
    backward.extend(points[points.size() - 1 - i]);
    GridGeometry::covering(forward, 0.05, 8.0, kPlenty);
  }
  EXPECT_EQ(GridGeometry::covering(forward, 0.05, 8.0, kPlenty),
            GridGeometry::covering(backward, 0.05, 8.0, kPlenty));
}

TEST(Covering, AllowsExactlyTheGivenCells) {
  const Box box{Position(0.5, 0.5), Position(2.5, 1.5)};
  EXPECT_EQ(GridGeometry::covering(box, 1.0, 1.0, 6).size(), 6U);
  EXPECT_TRUE(GridGeometry::canCover(box, 1.0, 1.0, 6));
  EXPECT_FALSE(GridGeometry::canCover(box, 1.0, 1.0, 5));
  EXPECT_NE(complaintOf([&] { GridGeometry::covering(box, 1.0, 1.0, 5); }).find("max_cells"),
            std::string::npos);
  EXPECT_NE(complaintOf([&] { GridGeometry::covering(box, 1.0, 1.0, 0); }).find("max_cells"),
            std::string::npos);
}

TEST(Covering, RefusesFourKilometresAtFiveCentimetres) {
  const Box box{Position(0, 0), Position(4000, 4000)};
  EXPECT_NE(
      complaintOf([&] { GridGeometry::covering(box, 0.05, 8.0, 16'000'000); }).find("max_cells"),
      std::string::npos);
}

TEST(Covering, RefusesAMapTooFarOut) {
  const Box far{Position(-1048575.9, 0.0), Position(-1048575.5, 0.1)};
  EXPECT_EQ(GridGeometry::covering(far, 0.5, 0.5, 100).origin(), Position(-1048576.0, 0.0));
  const Box farther{Position(0.0, 1048577.1), Position(0.1, 1048577.2)};
  EXPECT_TRUE(GridGeometry::canCover(far, 0.5, 0.5, 100));
  EXPECT_FALSE(GridGeometry::canCover(farther, 0.5, 0.5, 100));
  EXPECT_NE(complaintOf([&] { GridGeometry::covering(farther, 0.5, 0.5, 100); }).find("origin"),
            std::string::npos);
}

TEST(Covering, RefusesWhatIsNotFiniteOrPositive) {
  const Box box{Position(0, 0), Position(1, 1)};
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    EXPECT_FALSE(GridGeometry::canCover(box, bad, 1.0, 100));
    EXPECT_FALSE(GridGeometry::canCover(box, 1.0, bad, 100));
    EXPECT_NE(complaintOf([&] { GridGeometry::covering(box, bad, 1.0, 100); }).find("resolution_m"),
              std::string::npos);
    EXPECT_NE(complaintOf([&] { GridGeometry::covering(box, 1.0, bad, 100); }).find("step_m"),
              std::string::npos);
  }
  for (const Box& bad :
       {Box(), Box(Position(kNaN, 0), Position(1, 1)), Box(Position(0, 0), Position(1, kInfinity)),
        Box(Position(1, 1), Position(0, 0))}) {
    EXPECT_FALSE(GridGeometry::canCover(bad, 1.0, 1.0, 100));
    EXPECT_NE(complaintOf([&] { GridGeometry::covering(bad, 1.0, 1.0, 100); }).find("box"),
              std::string::npos);
  }
}

TEST(Covering, RefusesSizesBeyondAnyNumber) {
  const double huge = std::numeric_limits<double>::max();
  for (const Box& box :
       {Box(Position(-huge, -huge), Position(huge, huge)), Box(Position(huge, huge)),
        Box(Position(0, 0), Position(huge, 0)), Box(Position(1e17, 1e17))}) {
    for (const double resolution : {1e-300, 0.05}) {
      EXPECT_NE(complaintOf([&] { GridGeometry::covering(box, resolution, 1e-3, kPlenty); }),
                "nothing")
          << box.max() << " at " << resolution;
    }
  }
}

}  // namespace
}  // namespace sfw
