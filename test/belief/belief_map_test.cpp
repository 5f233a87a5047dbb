#include "structure_from_wifi/belief_map.h"

#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace sfw {
namespace {

/// A map of one row of cells.
BeliefMap row(const std::vector<float>& occupied, const Config::Belief& config = {}) {
  Grid<float> grid(GridGeometry(0.1, {0.0, 0.0}, static_cast<std::int64_t>(occupied.size()), 1));
  grid.cells = occupied;
  return {grid, config};
}

TEST(BeliefMap, IsUnknownAtFirst) {
  const BeliefMap belief(GridGeometry(0.05, {-1.0, 2.0}, 30, 20), {});
  for (std::int64_t y = 0; y < 20; ++y) {
    for (std::int64_t x = 0; x < 30; ++x) {
      ASSERT_EQ(belief.occupied({x, y}), 0.5F);
      ASSERT_FALSE(belief.known({x, y}));
      ASSERT_EQ(belief.state({x, y}), CellState::kUnknown);
    }
  }
}

TEST(BeliefMap, SeparatesStatesByItsThresholds) {
  const BeliefMap belief = row({0.1F, 0.15F, 0.4F, 0.5F, 0.6F, 0.7F, 0.9F});
  const std::vector<CellState> expected{
      CellState::kFree,    CellState::kFree,     CellState::kUnknown, CellState::kUnknown,
      CellState::kUnknown, CellState::kOccupied, CellState::kOccupied};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(belief.state({static_cast<std::int64_t>(i), 0}), expected[i]) << i;
  }
}

TEST(BeliefMap, TakesOtherThresholds) {
  Config::Belief config;
  config.free_threshold = 0.05;
  config.occupied_threshold = 0.95;
  const BeliefMap belief = row({0.01F, 0.1F, 0.9F, 0.99F}, config);
  EXPECT_EQ(belief.state({0, 0}), CellState::kFree);
  EXPECT_EQ(belief.state({1, 0}), CellState::kUnknown);
  EXPECT_EQ(belief.state({2, 0}), CellState::kUnknown);
  EXPECT_EQ(belief.state({3, 0}), CellState::kOccupied);
}

TEST(BeliefMap, KeepsUnseenCellsUnknown) {
  Config::Belief config;
  config.free_threshold = 0.6;
  config.occupied_threshold = 0.6;
  const BeliefMap belief = row({0.5F, 0.45F}, config);
  EXPECT_EQ(belief.state({0, 0}), CellState::kUnknown);
  EXPECT_EQ(belief.state({1, 0}), CellState::kFree);
}

TEST(BeliefMap, KeepsProbabilitiesToOneStepOfItsLogOdds) {
  for (int i = 1; i < 1000; ++i) {
    const float p = static_cast<float>(i) / 1000.0F;
    // Steps of 1/16 in log-odds are at most 1/64 in probability, and rounding takes half of one;
    // MRPT truncates, which takes a whole one.
    EXPECT_NEAR(row({p}).occupied({0, 0}), p, 1.0 / 64.0 + 1e-6) << p;
  }
}

TEST(BeliefMap, NeverLeansTheOtherWay) {
  for (int i = 0; i <= 1000; ++i) {
    const float p = static_cast<float>(i) / 1000.0F;
    const float kept = row({p}).occupied({0, 0});
    EXPECT_GE((kept - 0.5F) * (p - 0.5F), 0.0F) << p << " became " << kept;
  }
}

TEST(BeliefMap, EndsNearCertainty) {
  const BeliefMap belief = row({0.0F, 1.0F, 1e-30F, 1.0F - 1e-7F});
  EXPECT_NEAR(belief.occupied({0, 0}), 0.00036, 1e-5);
  EXPECT_NEAR(belief.occupied({1, 0}), 0.99964, 1e-5);
  EXPECT_EQ(belief.state({0, 0}), CellState::kFree);
  EXPECT_EQ(belief.state({1, 0}), CellState::kOccupied);
  EXPECT_EQ(belief.state({2, 0}), CellState::kFree);
  EXPECT_EQ(belief.state({3, 0}), CellState::kOccupied);
}

TEST(BeliefMap, TakesInvalidProbabilitiesForUnknown) {
  const float infinity = std::numeric_limits<float>::infinity();
  const BeliefMap belief =
      row({std::numeric_limits<float>::quiet_NaN(), -0.01F, 1.01F, infinity, -infinity, 300.0F});
  for (std::int64_t x = 0; x < 6; ++x) {
    EXPECT_EQ(belief.occupied({x, 0}), 0.5F);
    EXPECT_FALSE(belief.known({x, 0}));
  }
}

TEST(BeliefMap, ConvertsEachCellByItsBelief) {
  Grid<float> occupied(GridGeometry(0.05, {0.0, 0.0}, 37, 11));
  std::mt19937 random(3);
  for (float& p : occupied.cells) {
    p = static_cast<float>(random() % 1001) / 1000.0F;
  }
  const BeliefMap belief(occupied, {});
  const std::vector<float> converted = belief.converted([](const CellBelief& cell) {
    return cell.occupied + (cell.known ? 2.0F : 0.0F) + 4.0F * static_cast<float>(cell.state);
  });
  for (std::size_t i = 0; i < occupied.cells.size(); ++i) {
    const Cell c = occupied.geometry.cell(i);
    ASSERT_EQ(converted[i], belief.occupied(c) + (belief.known(c) ? 2.0F : 0.0F) +
                                4.0F * static_cast<float>(belief.state(c)));
  }
}

TEST(BeliefMap, AgreesWithItsMrptGrid) {
  Grid<float> occupied(GridGeometry(0.05, {-8.0, 16.0}, 160, 320));
  std::mt19937 random(2);
  for (float& p : occupied.cells) {
    p = static_cast<float>(random() % 1001) / 1000.0F;
  }
  const BeliefMap belief(occupied, {});
  const auto& grid = belief.grid();
  EXPECT_EQ(grid.getSizeX(), 160U);
  EXPECT_EQ(grid.getSizeY(), 320U);
  EXPECT_NEAR(grid.getXMin(), -8.0, 1e-5);
  EXPECT_NEAR(grid.getYMax(), 32.0, 1e-5);
  for (std::int64_t y = 0; y < 320; ++y) {
    for (std::int64_t x = 0; x < 160; ++x) {
      const Position centre = occupied.geometry.centre({x, y});
      ASSERT_EQ(1.0F - grid.getPos(static_cast<float>(centre.x()), static_cast<float>(centre.y())),
                belief.occupied({x, y}));
    }
  }
}

TEST(BeliefMap, TakesAnySizeThatAMapOfABuildingHas) {
  for (const double resolution : {0.05, 0.1, 0.03, 0.07, 0.25}) {
    for (const double far : {0.0, -120.0, 1000.0}) {
      for (const std::int64_t side : {1, 2, 161, 1999}) {
        const double origin = std::round(far / resolution) * resolution;
        EXPECT_NO_THROW(BeliefMap(GridGeometry(resolution, {origin, -origin}, side, 3), {}))
            << resolution << " m, " << far << " m, " << side;
      }
    }
  }
}

TEST(BeliefMap, RefusesAGridTooFarOutForMrpt) {
  for (const double far : {1.1e5, 1e7, 1e9, -1e12}) {
    EXPECT_THROW(BeliefMap(GridGeometry(0.05, {far, 0.0}, 100, 100), {}), std::invalid_argument)
        << far;
  }
}

TEST(BeliefMap, FitsMrptAsFarOutAsAnyMapMayLie) {
  for (const double resolution : {0.05, 0.1, 0.03}) {
    const double far = GridGeometry::kFarthestMap * resolution * (1.0 - 1e-12);
    const GridGeometry geometry(resolution, {far, -far}, 50, 70);
    const BeliefMap belief(geometry, {});
    EXPECT_EQ(belief.grid().getSizeX(), 50U);
    EXPECT_EQ(belief.grid().getSizeY(), 70U);
    EXPECT_NEAR(belief.grid().getXMin(), far, resolution / 2);
    EXPECT_NEAR(belief.grid().getYMin(), -far, resolution / 2);
  }
}

}  // namespace
}  // namespace sfw
