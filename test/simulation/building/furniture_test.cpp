#include "simulation/building/furniture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/moments.h"

namespace sfw {
namespace {

/// 60 x 30 m of 0.1 m cells; the left half is free.
FloorPlan halfFree() {
  FloorPlan plan(GridGeometry(0.1, {-5.0, 2.0}, 600, 300), Material::kInteriorWall);
  Cell c;
  for (c.y = 0; c.y < 300; ++c.y) {
    for (c.x = 0; c.x < 300; ++c.x) {
      plan[c] = Material::kFree;
    }
  }
  return plan;
}

TEST(Furniture, OnePieceForSoMuchFreeSpace) {
  const FloorPlan plan = halfFree();
  const std::vector<Furniture> pieces = placeFurniture(plan, 5.0, 9.0, 3);
  EXPECT_EQ(pieces.size(), 100U);
  for (const Furniture& piece : pieces) {
    EXPECT_EQ(plan[plan.geometry.cellAt(piece.centre)], Material::kFree);
    EXPECT_GE(piece.radius_m, 0.2);
    EXPECT_LE(piece.radius_m, 0.5);
  }
}

TEST(Furniture, LossesAreUniform) {
  std::vector<double> losses;
  for (std::int64_t seed = 0; seed < 20; ++seed) {
    for (const Furniture& piece : placeFurniture(halfFree(), 5.0, 9.0, seed)) {
      losses.push_back(piece.loss_db);
    }
  }
  EXPECT_GE(*std::min_element(losses.begin(), losses.end()), 0.0);
  EXPECT_LE(*std::max_element(losses.begin(), losses.end()), 5.0);
  const double deviation = 5.0 / std::sqrt(12.0);
  EXPECT_NEAR(test::momentsOf(losses).mean, 2.5, 4.0 * deviation / std::sqrt(2000.0));
  EXPECT_NEAR(test::momentsOf(losses).deviation, deviation, 4.0 * deviation / std::sqrt(4000.0));
}

TEST(Furniture, SeedsFurnishDifferently) {
  const auto first = placeFurniture(halfFree(), 5.0, 9.0, 1);
  const auto again = placeFurniture(halfFree(), 5.0, 9.0, 1);
  const auto other = placeFurniture(halfFree(), 5.0, 9.0, 2);
  EXPECT_EQ(first[7].centre, again[7].centre);
  EXPECT_EQ(first[7].loss_db, again[7].loss_db);
  EXPECT_NE(first[7].centre, other[7].centre);
}

TEST(Furniture, NoFreeSpaceNoFurniture) {
  const FloorPlan plan(GridGeometry(0.1, Position::Zero(), 100, 100), Material::kUnknown);
  EXPECT_TRUE(placeFurniture(plan, 5.0, 9.0, 1).empty());
}

TEST(Furniture, WeakensTheLinesThroughIt) {
  const std::vector<Furniture> pieces{{{2, 0}, 0.5, 3.0}, {{4, 0.4}, 0.5, 1.0}};
  EXPECT_EQ(furnitureLoss(pieces, {0, 0}, {6, 0}), 4.0);
  EXPECT_EQ(furnitureLoss(pieces, {6, 0}, {0, 0}), 4.0);
  EXPECT_EQ(furnitureLoss(pieces, {0, 0}, {3, 0}), 3.0);
  EXPECT_EQ(furnitureLoss(pieces, {0, -0.2}, {6, -0.2}), 3.0);
  EXPECT_EQ(furnitureLoss(pieces, {0, 0}, {1, 0}), 0.0);  // ends before it
  EXPECT_EQ(furnitureLoss(pieces, {2, 0}, {2, 0}), 3.0);
}

}  // namespace
}  // namespace sfw
