#include "tomography/line_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>

#include "base/constants.h"
#include "support/radio_walls.h"

namespace sfw {
namespace {

using test::binsThrough;
using test::coveredBy;
using test::placesAlong;
using test::StraightWall;

/// "x" for a line across x, "y" for one across y, then column and row.
std::vector<std::string> linesBetween(const Position& from, const Position& to,
                                      const GridGeometry& geometry = {1.0, {0.0, 0.0}, 5, 5}) {
  std::vector<std::string> lines;
  forEachLine(geometry, from, to, [&](bool walls_along_y, Cell cell) {
    lines.push_back((walls_along_y ? "x" : "y") + std::to_string(cell.x) + std::to_string(cell.y));
  });
  return lines;
}

using Lines = std::vector<std::string>;

TEST(ForEachLine, MeetsTheMiddlesOfCells) {
  EXPECT_EQ(linesBetween({0.2, 1.3}, {3.7, 1.3}), (Lines{"x01", "x11", "x21", "x31"}));
  EXPECT_EQ(linesBetween({1.3, 0.7}, {1.3, 3.2}), (Lines{"y11", "y12"}));
}

TEST(ForEachLine, MeetsBothDirectionsOnASlant) {
  EXPECT_EQ(linesBetween({0.0, 0.2}, {4.0, 2.2}),
            (Lines{"x00", "x10", "x21", "x31", "y00", "y21"}));
  EXPECT_EQ(linesBetween({0.0, 2.2}, {4.0, 0.2}),
            (Lines{"x01", "x11", "x20", "x30", "y30", "y11"}));
}

TEST(ForEachLine, LeavesOutLinesThroughItsEnds) {
  EXPECT_EQ(linesBetween({0.5, 1.3}, {2.5, 1.3}), (Lines{"x11"}));
  EXPECT_EQ(linesBetween({0.6, 1.3}, {1.4, 1.3}), Lines());
  EXPECT_EQ(linesBetween({0.6, 0.5}, {3.4, 0.5}), (Lines{"x10", "x20"}));
  EXPECT_EQ(linesBetween({2.5, 2.5}, {2.5, 2.5}), Lines());
  EXPECT_EQ(linesBetween({0.3, 0.3}, {0.3, 0.3}), Lines());
}

TEST(ForEachLine, StaysOnTheGrid) {
  EXPECT_EQ(linesBetween({-9.0, 1.3}, {2.0, 1.3}), (Lines{"x01", "x11"}));
  EXPECT_EQ(linesBetween({3.0, 1.3}, {1e15, 1.3}), (Lines{"x31", "x41"}));
  EXPECT_EQ(linesBetween({0.0, 7.0}, {5.0, 7.0}), Lines());
  EXPECT_EQ(linesBetween({-3.0, 1e12}, {9.0, 1e13}), Lines());
}

TEST(ForEachLine, IsTheSameFromBothEnds) {
  const GridGeometry geometry(0.2, {-1.3, 0.7}, 40, 30);
  Random random(1, 1, 0);
  const auto somewhere = [&] {
    const double x = random.uniform(-3.0, 8.0);
    return Position(x, random.uniform(-1.0, 8.0));
  };
  for (int i = 0; i < 1000; ++i) {
    const Position from = somewhere(), to = somewhere();
    EXPECT_EQ(linesBetween(from, to, geometry), linesBetween(to, from, geometry));
  }
}

const std::atomic<bool> kNever{false};
const GridGeometry kHall(0.2, {0.0, 0.0}, 40, 30);  // 8 x 6 m
const Position kLeft(0.5, 3.1), kLow(4.1, 0.3);

/// To and fro in the right part of the hall.
std::vector<Position> places() {
  return placesAlong({{5.5, 0.5},
                      {5.5, 5.5},
                      {6.3, 5.5},
                      {6.3, 0.5},
                      {7.1, 0.5},
                      {7.1, 5.5},
                      {2.1, 5.5},
                      {2.1, 0.5}});
}

LineFieldConfig additive() {
  LineFieldConfig config;
  config.max_total_wall_loss_db = std::numeric_limits<double>::infinity();
  return config;
}

LineField solved(const std::vector<AccessPointBins>& access_points,
                 const LineFieldConfig& config = additive(),
                 const std::atomic<bool>& stop = kNever) {
  return solveLineField({{kHall}}, access_points, {coveredBy(kHall, places(), 0.2)}, config, stop);
}

float mostOf(const Grid<float>& grid) {
  return *std::max_element(grid.cells.begin(), grid.cells.end());
}

float leastOf(const Grid<float>& grid) {
  return *std::min_element(grid.cells.begin(), grid.cells.end());
}

const StraightWall kWall{true, 3.9, 0.0, 6.0, 6.0};

TEST(LineField, FindsAWallAtItsPlaceWithItsLoss) {
  const LineField field = solved({binsThrough({kWall}, kLeft, places())});
  // For all that one access point says, the wall stands anywhere between the two lanes; sparsity
  // and few iterations leave part of the loss to path loss.
  EXPECT_NEAR(lossBetween(field, {2.3, 3.1}, {5.3, 3.1}), 5.0, 1.5);
  EXPECT_LT(lossBetween(field, {0.5, 3.1}, {1.9, 3.1}), 0.5);
  EXPECT_LT(lossBetween(field, {5.3, 3.1}, {7.9, 3.1}), 0.5);
  EXPECT_GE(leastOf(field[0].walls_along_y), 0.0F);
}

TEST(LineField, TwoAccessPointsPinAWallsEndDown) {
  const StraightWall half{true, 3.9, 3.0, 6.0, 8.0};
  const LineField field =
      solved({binsThrough({half}, kLeft, places()), binsThrough({half}, kLow, places())});
  EXPECT_GT(lossBetween(field, {2.3, 4.1}, {5.3, 4.1}), 4.0);
  EXPECT_LT(lossBetween(field, {2.3, 1.1}, {5.3, 1.1}), 2.0);
}

TEST(LineField, FindsNothingWhereThereIsNoWall) {
  const LineField field =
      solved({binsThrough({}, kLeft, places()), binsThrough({}, kLow, places())});
  EXPECT_LT(mostOf(field[0].walls_along_y), 0.1F);
  EXPECT_LT(mostOf(field[0].walls_along_x), 0.1F);
}

TEST(LineField, PutsNoWallWhereTheRobotWas) {
  const Mask driven = coveredBy(kHall, places(), 0.2);
  const LineField field = solved({binsThrough({kWall}, kLeft, places(), 1e300, 3.0)});
  for (std::size_t i = 0; i < driven.cells.size(); ++i) {
    EXPECT_TRUE(driven.cells[i] == 0 ||
                field[0].walls_along_y.cells[i] + field[0].walls_along_x.cells[i] == 0.0F);
  }
}

TEST(LineField, PutsNoWallWhereNoRayCrosses) {
  const LineField field = solved({binsThrough({kWall}, kLeft, places(), 1e300, 3.0)});
  for (std::int64_t y = 0; y < kHall.height(); ++y) {
    EXPECT_EQ((field[0].walls_along_y[{0, y}]), 0.0F);
    EXPECT_EQ((field[0].walls_along_y[{38, y}]), 0.0F);
  }
}

TEST(LineField, UndoesSaturation) {
  LineFieldConfig config;
  config.iterations = 2000;
  const std::vector<StraightWall> walls{{true, 3.9, 0.0, 6.0, 12.0}};
  const AccessPointBins access_point =
      binsThrough(walls, kLeft, places(), config.max_total_wall_loss_db);
  const double with = lossBetween(solved({access_point}, config), {2.3, 3.1}, {5.3, 3.1});
  const double without = lossBetween(solved({access_point}), {2.3, 3.1}, {5.3, 3.1});
  EXPECT_NEAR(without, 15.0 * (1.0 - std::exp(-12.0 / 15.0)), 2.0);
  EXPECT_NEAR(with, 12.0, 3.0);
  EXPECT_GT(with, without);
}

TEST(LineField, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  const LineField field = solved({binsThrough({kWall}, kLeft, places())}, additive(), stop);
  EXPECT_EQ(mostOf(field[0].walls_along_y), 0.0F);
  EXPECT_EQ(mostOf(field[0].walls_along_x), 0.0F);
}

TEST(LineField, IsTheSameEachTime) {
  const AccessPointBins access_point = binsThrough({kWall}, kLeft, places(), 15.0, 2.0);
  const LineField first = solved({access_point}, LineFieldConfig());
  const LineField again = solved({access_point}, LineFieldConfig());
  EXPECT_EQ(first[0].walls_along_y.cells, again[0].walls_along_y.cells);
  EXPECT_EQ(first[0].walls_along_x.cells, again[0].walls_along_x.cells);
}

TEST(LineField, OrderOfAccessPointsDoesNotMatter) {
  const AccessPointBins left = binsThrough({kWall}, kLeft, places(), 15.0, 2.0);
  const AccessPointBins low = binsThrough({kWall}, kLow, places(), 15.0, 2.0);
  const LineField one = solved({left, low}, LineFieldConfig());
  const LineField other = solved({low, left}, LineFieldConfig());
  for (std::size_t i = 0; i < one[0].walls_along_y.cells.size(); ++i) {
    EXPECT_NEAR(one[0].walls_along_y.cells[i], other[0].walls_along_y.cells[i], 0.02);
    EXPECT_NEAR(one[0].walls_along_x.cells[i], other[0].walls_along_x.cells[i], 0.02);
  }
}

TEST(LineField, ExplainsASlantedWallBetterWithALatticeAlongIt) {
  const LineLattice slant{GridGeometry(0.2, {0.0, -5.8}, 50, 51), kPi / 4.0};
  // Across the slant's x axis, hence from upper left to lower right of the hall.
  const StraightWall wall{true, 5.5, -6.0, 6.0, 6.0};
  std::vector<Position> turned;
  for (const Position& place : places()) {
    turned.push_back(slant.toLattice(place));
  }
  AccessPointBins access_point = binsThrough({wall}, slant.toLattice({1.0, 0.7}), turned);
  access_point.position = slant.toBuilding(access_point.position);
  for (RadioBin& bin : access_point.bins) {
    bin.position = slant.toBuilding(bin.position);
  }
  const std::vector<Mask> driven{coveredBy(kHall, places(), 0.2),
                                 coveredBy(slant.geometry, turned, 0.2)};
  const LineField field =
      solveLineField({{kHall}, slant}, {access_point}, driven, additive(), kNever);
  const LineField straight =
      solveLineField({{kHall}}, {access_point}, {driven.front()}, additive(), kNever);
  const auto error = [&](const LineField& found) {
    double squares = 0.0;
    for (std::size_t i = 0; i < turned.size(); ++i) {
      const bool hidden = crosses(wall, slant.toLattice(access_point.position), turned[i]);
      const double loss = lossBetween(found, access_point.position, access_point.bins[i].position);
      squares += std::pow(loss - (hidden ? 6.0 : 0.0), 2);
    }
    return std::sqrt(squares / static_cast<double>(turned.size()));
  };
  EXPECT_LT(error(field), 0.9 * error(straight));
}

TEST(LineField, FindsNoWallWithoutReadings) {
  AccessPointBins silent;
  silent.position = kLeft;
  for (const std::vector<AccessPointBins>& access_points :
       {std::vector<AccessPointBins>(), std::vector<AccessPointBins>{silent}}) {
    EXPECT_EQ(mostOf(solved(access_points)[0].walls_along_y), 0.0F);
  }
}

}  // namespace
}  // namespace sfw
