#include "belief/free_probability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "support/ascii_world.h"
#include "support/number_table.h"

namespace sfw::test {
namespace {

// ---- Straightening: lines of 0.6 m to both sides are 7 cells of 0.2 m ----

const GridGeometry kSquare(0.2, {0.0, 0.0}, 7, 7);

std::vector<std::size_t> allCells() {
  std::vector<std::size_t> cells(kSquare.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  return cells;
}

TEST(Straighten, KeepsALineOfDoubt) {
  Grid<float> log_odds = gridFrom<float>(std::vector<std::string>(7, "+++-+++"), 0.2,
                                         [](char c) { return c == '+' ? 1.0F : -1.0F; });
  straighten(allCells(), log_odds);
  // Beside the line: 0.3 of 1, and 0.7 of the mean of the row, as far as it reaches on the grid.
  constexpr double k4 = 0.3 + 0.7 * (3 - 1) / 4, k5 = 0.3 + 0.7 * (4 - 1) / 5;
  constexpr double k6 = 0.3 + 0.7 * (5 - 1) / 6;
  expectEachRow(log_odds, {k4, k5, k6, -1.0, k6, k5, k4});
}

TEST(Straighten, LetsASingleDoubtFadeAndSpreadAlongBothAxes) {
  Grid<float> log_odds(kSquare, 2.0F);
  log_odds[{3, 3}] = -7.0F;
  straighten(allCells(), log_odds);
  // 0.3 of the cell's own, and 0.7 of the mean of a line with the doubtful cell.
  constexpr double kHere = 0.3 * -7 + 0.7 * (6 * 2 - 7) / 7;
  constexpr double k4 = 0.3 * 2 + 0.7 * (3 * 2 - 7) / 4;
  constexpr double k5 = 0.3 * 2 + 0.7 * (4 * 2 - 7) / 5;
  constexpr double k6 = 0.3 * 2 + 0.7 * (5 * 2 - 7) / 6;
  expectTable(log_odds, {{2, 2, 2, k4, 2, 2, 2},
                         {2, 2, 2, k5, 2, 2, 2},
                         {2, 2, 2, k6, 2, 2, 2},
                         {k4, k5, k6, kHere, k6, k5, k4},
                         {2, 2, 2, k6, 2, 2, 2},
                         {2, 2, 2, k5, 2, 2, 2},
                         {2, 2, 2, k4, 2, 2, 2}});
}

TEST(Straighten, CountsDescribedCellsOnly) {
  Grid<float> log_odds(kSquare);
  log_odds[{2, 3}] = 4.0F;
  log_odds[{3, 3}] = 2.0F;
  straighten({kSquare.index({2, 3}), kSquare.index({3, 3})}, log_odds);
  // The mean of the row is 3; that of each column is the cell itself.
  EXPECT_NEAR((log_odds[{2, 3}]), 0.3 * 4 + 0.7 * 3, 1e-6);
  EXPECT_NEAR((log_odds[{3, 3}]), 2.0, 1e-6);
  EXPECT_EQ((log_odds[{4, 3}]), 0.0F);
}

// ---- The probability that follows ----

/// Cells of a square that are judged free but for the doubtful ones.
CellFeatures squareWithDoubt(const std::vector<Cell>& doubtful) {
  constexpr std::int64_t kCells = 61;
  CellFeatures square{{0.05, Position(0.0, 0.0), kCells, kCells}, {}, {}, {}};
  square.cells.resize(kCells * kCells);
  std::iota(square.cells.begin(), square.cells.end(), std::size_t{0});
  square.values.resize(square.cells.size());
  for (const Cell& c : doubtful) {
    square.values[square.geometry.index(c)][0] = 1.0F;
  }
  return square;
}

/// Free by log odds of 2, doubtful by -2.
BeliefModel doubting() {
  std::array<BeliefModel::Expert, kDrivingStyles> experts;
  experts[0].with_radio.intercept = 2.0;
  experts[0].with_radio.features[0] = -4.0;
  return BeliefModel(experts);
}

Grid<float> freeWithDoubt(const std::vector<Cell>& doubtful) {
  return freeProbability(squareWithDoubt(doubtful), doubting(), {1.0, 0.0, 0.0}, UseRadio::kYes);
}

double logOdds(float p) {
  return std::log(static_cast<double>(p) / (1.0 - static_cast<double>(p)));
}

TEST(FreeProbability, IsTheModelsWhereAllCellsAreAlike) {
  EXPECT_NEAR(logOdds(freeWithDoubt({})[Cell{30, 30}]), 2.0, 1e-4);
}

TEST(FreeProbability, KeepsALineOfDoubtAndClosesItsGaps) {
  std::vector<Cell> wall;
  for (std::int64_t y = 0; y < 61; ++y) {
    for (std::int64_t x = 27; x < 34; ++x) {  // wider than the blur
      if (y < 28 || y > 32) {
        wall.push_back({x, y});
      }
    }
  }
  const Grid<float> free = freeWithDoubt(wall);
  EXPECT_LT(free[(Cell{30, 10})], 0.2F);
  EXPECT_LT(free[(Cell{30, 30})], 0.5F) << "a gap of 0.25 m, along the wall";
  EXPECT_GT(free[(Cell{10, 30})], 0.8F);
}

TEST(FreeProbability, LetsSingleDoubtFade) {
  std::vector<Cell> spot;
  for (std::int64_t y = 28; y < 33; ++y) {
    for (std::int64_t x = 28; x < 33; ++x) {
      spot.push_back({x, y});
    }
  }
  // Of a row of 25 cells 5 are doubtful: 0.3 * -2 + 0.7 * (20 * 2 - 5 * 2) / 25.
  EXPECT_NEAR(logOdds(freeWithDoubt(spot)[Cell{30, 30}]), 0.24, 1e-4);
}

TEST(FreeProbability, DoesNotPreferAnAxis) {
  std::vector<Cell> lying, standing;
  for (std::int64_t i = 5; i < 40; ++i) {
    lying.push_back({i, 20});
    standing.push_back({20, i});
  }
  const Grid<float> a = freeWithDoubt(lying), b = freeWithDoubt(standing);
  for (std::int64_t y = 0; y < 61; ++y) {
    for (std::int64_t x = 0; x < 61; ++x) {
      ASSERT_NEAR((a[Cell{x, y}]), (b[Cell{y, x}]), 1e-5);
    }
  }
}

}  // namespace
}  // namespace sfw::test
