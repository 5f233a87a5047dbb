#include "grid/ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/ascii_world.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

std::vector<Cell> cellsOn(const GridGeometry& geometry, const Position& from, const Position& to) {
  std::vector<Cell> cells;
  Ray(geometry, from, to).forEachCell([&](Cell c) { cells.push_back(c); });
  return cells;
}

/// The cells of a segment on a grid of 1 m cells, '#' crossed.
Rows drawn(const Position& from, const Position& to, std::int64_t width, std::int64_t height) {
  Mask crossed(GridGeometry(1.0, {0, 0}, width, height));
  for (const Cell c : cellsOn(crossed.geometry, from, to)) {
    crossed[c] = 1;
  }
  return test::rowsOf(crossed);
}

TEST(Ray, CrossesTheCellsOfHandDrawnSegments) {
  EXPECT_EQ(drawn({0.5, 0.5}, {5.5, 2.5}, 6, 3), (Rows{"....##",  //
                                                       ".####.",  //
                                                       "##...."}));
  EXPECT_EQ(drawn({0.2, 1.5}, {4.9, 1.6}, 5, 3), (Rows{".....",  //
                                                       "#####",  //
                                                       "....."}));
  EXPECT_EQ(drawn({1.5, 2.9}, {1.4, 0.1}, 3, 3), (Rows{".#.",  //
                                                       ".#.",  //
                                                       ".#."}));
  EXPECT_EQ(drawn({0.9, 2.5}, {2.1, 0.5}, 3, 3), (Rows{"##.",  //
                                                       ".#.",  //
                                                       ".##"}));
}

TEST(Ray, StepsDiagonallyThroughCorners) {
  EXPECT_EQ(drawn({0.5, 0.5}, {3.5, 3.5}, 4, 4), (Rows{"...#",  //
                                                       "..#.",  //
                                                       ".#..",  //
                                                       "#..."}));
  EXPECT_EQ(drawn({0.5, 3.5}, {3.5, 0.5}, 4, 4), (Rows{"#...",  //
                                                       ".#..",  //
                                                       "..#.",  //
                                                       "...#"}));
  EXPECT_EQ(drawn({0.5, 0.25}, {3.5, 1.75}, 4, 2), (Rows{"..##",  //
                                                         "##.."}));
}

TEST(Ray, IsASingleCellWhenItsEndsShareOne) {
  const GridGeometry geometry(1.0, {0, 0}, 3, 3);
  for (const Position& to : {Position(1.0, 2.0), Position(1.3, 2.7), Position(1.999, 2.999)}) {
    EXPECT_EQ(cellsOn(geometry, {1.3, 2.7}, to), (std::vector<Cell>{{1, 2}}));
  }
}

TEST(Ray, PassesCellsOutsideTheGridToo) {
  const GridGeometry geometry(0.5, {10.0, -4.0}, 2, 2);
  EXPECT_EQ(cellsOn(geometry, {9.25, -3.75}, {11.25, -3.75}),
            (std::vector<Cell>{{-2, 0}, {-1, 0}, {0, 0}, {1, 0}, {2, 0}}));
}

/// Points on a lattice of 1/64 cell, never on a border, so that all below is exact.
class RandomPoints {
 public:
  RandomPoints(std::uint32_t seed, std::int64_t reach) : random_(seed), cell_(-reach, reach) {}

  Position next() { return {coordinate(), coordinate()}; }

 private:
  double coordinate() {
    const double within = static_cast<double>(1 + random_() % 63) / 64.0;
    return static_cast<double>(cell_(random_)) + within;
  }

  std::mt19937 random_;
  std::uniform_int_distribution<std::int64_t> cell_;
};

/// Whether a segment passes through the inside of a cell: the open interval of its parameter in
/// which it is between the cell's borders is not empty. In whole numbers: 1/64 cell.
bool passesThrough(const Position& from, const Position& to, Cell c) {
  const auto whole = [](double coordinate) { return std::llround(coordinate * 64.0); };
  // The interval (low, high) with a common denominator, as numerators.
  const std::int64_t length[] = {whole(to.x()) - whole(from.x()), whole(to.y()) - whole(from.y())};
  const std::int64_t start[] = {whole(from.x()), whole(from.y())};
  const std::int64_t border[] = {c.x * 64, c.y * 64};
  std::int64_t scale = 1;
  for (const std::int64_t l : length) {
    scale *= l == 0 ? 1 : std::abs(l);
  }
  std::int64_t low = 0;
  std::int64_t high = scale;
  for (int axis = 0; axis < 2; ++axis) {
    const std::int64_t enter = border[axis] - start[axis];
    const std::int64_t leave = enter + 64;
    if (length[axis] == 0) {
      if (enter >= 0 || leave <= 0) {
        return false;
      }
      continue;
    }
    const std::int64_t unit = scale / length[axis];  // signed
    low = std::max(low, std::min(enter * unit, leave * unit));
    high = std::min(high, std::max(enter * unit, leave * unit));
  }
  // An end inside the cell counts even if the segment is a point.
  return low < high;
}

using CellSet = std::set<std::pair<std::int64_t, std::int64_t>>;

CellSet setOf(const std::vector<Cell>& cells) {
  CellSet set;
  for (const Cell c : cells) {
    set.emplace(c.x, c.y);
  }
  return set;
}

TEST(Ray, AgreesWithTheIntersectionOfSegmentAndCells) {
  const GridGeometry geometry(1.0, {0, 0}, 1, 1);
  RandomPoints points(7, 8);
  for (int i = 0; i < 2000; ++i) {
    const Position from = points.next();
    const Position to = points.next();
    CellSet expected;
    for (std::int64_t y = -10; y <= 10; ++y) {
      for (std::int64_t x = -10; x <= 10; ++x) {
        if (passesThrough(from, to, {x, y})) {
          expected.emplace(x, y);
        }
      }
    }
    ASSERT_EQ(setOf(cellsOn(geometry, from, to)), expected)
        << "(" << from.transpose() << ") to (" << to.transpose() << ")";
  }
}

TEST(Ray, IsTheSameBackwards) {
  const GridGeometry geometry(0.05, {-3.15, 1.4}, 1, 1);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-20.0, 20.0);
  for (int i = 0; i < 5000; ++i) {
    const Position from(coordinate(random), coordinate(random));
    const Position to(coordinate(random), coordinate(random));
    std::vector<Cell> backwards = cellsOn(geometry, to, from);
    std::reverse(backwards.begin(), backwards.end());
    ASSERT_EQ(cellsOn(geometry, from, to), backwards);
  }
}

TEST(Ray, StepsToNeighboursFromEndToEnd) {
  const GridGeometry geometry(0.1, {0.0, 0.0}, 1, 1);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-9.0, 9.0);
  for (int i = 0; i < 5000; ++i) {
    const Position from(coordinate(random), coordinate(random));
    const Position to(coordinate(random), coordinate(random));
    const std::vector<Cell> cells = cellsOn(geometry, from, to);
    ASSERT_EQ(cells.front(), geometry.cellAt(from));
    ASSERT_EQ(cells.back(), geometry.cellAt(to));
    for (std::size_t j = 1; j < cells.size(); ++j) {
      const std::int64_t dx = cells[j].x - cells[j - 1].x;
      const std::int64_t dy = cells[j].y - cells[j - 1].y;
      ASSERT_LE(std::max(std::abs(dx), std::abs(dy)), 1);
      ASSERT_NE(std::abs(dx) + std::abs(dy), 0);
      // Never away from the goal.
      ASSERT_GE(static_cast<double>(dx) * (to.x() - from.x()), 0.0);
      ASSERT_GE(static_cast<double>(dy) * (to.y() - from.y()), 0.0);
    }
  }
}

TEST(Ray, IsExactFarFromTheOrigin) {
  const GridGeometry geometry(1.0, {0, 0}, 1, 1);
  const double far = static_cast<double>(1 << 19) - 1.0;
  for (const double sign : {-1.0, 1.0}) {
    const Position near(0.5, 0.5);
    const Position end(sign * far + 0.5, far + 0.5);
    const std::vector<Cell> diagonal = cellsOn(geometry, near, end);
    ASSERT_EQ(diagonal.size(), static_cast<std::size_t>(far) + 1);
    EXPECT_EQ(diagonal.back(), geometry.cellAt(end));
    const std::vector<Cell> whole =
        cellsOn(geometry, {-far, sign * far + 0.25}, {far, 0.75 - sign * far});
    std::vector<Cell> backwards =
        cellsOn(geometry, {far, 0.75 - sign * far}, {-far, sign * far + 0.25});
    std::reverse(backwards.begin(), backwards.end());
    EXPECT_EQ(whole, backwards);
  }
}

}  // namespace
}  // namespace sfw
