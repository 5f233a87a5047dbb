#include "belief/shortest_paths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "belief/cell_features.h"
#include "grid/distance_transform.h"

namespace sfw {
namespace {

const std::atomic<bool> kNever{false};
const GridGeometry kField(0.1, {0.0, 0.0}, 60, 30);

Mask pathAt(const std::vector<Cell>& cells) {
  Mask path(kField);
  for (const Cell c : cells) {
    path[c] = 1;
  }
  return path;
}

ShortestPaths waysOver(const Mask& path, const Grid<float>& strength,
                       const std::atomic<bool>& stop = kNever) {
  return shortestPathsFrom(path, distanceTransform(path), strength, stop);
}

TEST(ShortestPaths, AreAsLongAsTheyAreWithoutWalls) {
  const ShortestPaths ways = waysOver(pathAt({{5, 5}}), Grid<float>(kField));
  EXPECT_EQ((ways.cost[{5, 5}]), 0.0F);
  EXPECT_NEAR((ways.cost[{15, 5}]), 1.0, 1e-4);
  EXPECT_NEAR((ways.cost[{15, 15}]), std::sqrt(2.0), 1e-4);
  EXPECT_NEAR((ways.cost[{15, 9}]), 0.6 + 0.4 * std::sqrt(2.0), 1e-4);
}

TEST(ShortestPaths, StartFromTheCheapestCellOfThePath) {
  const ShortestPaths ways = waysOver(pathAt({{5, 5}, {25, 5}}), Grid<float>(kField));
  EXPECT_EQ((ways.source[{14, 5}]), kField.index({5, 5}));
  EXPECT_EQ((ways.source[{16, 5}]), kField.index({25, 5}));
}

TEST(ShortestPaths, PayForWallsOrGoRound) {
  Grid<float> strength(kField);
  for (std::int64_t y = 0; y < 20; ++y) {
    strength[{10, y}] = 4.0F;  // [dB], a cell thick
  }
  const ShortestPaths ways = waysOver(pathAt({{5, 5}}), strength);
  EXPECT_NEAR((ways.cost[{15, 5}]), 1.0 + 0.1 * 2.0 * 4.0, 1e-4);
  EXPECT_NEAR((ways.cost[{9, 5}]), 0.4, 1e-4);
  strength[{10, 6}] = 0.0F;  // a gap beside
  EXPECT_NEAR((waysOver(pathAt({{5, 5}}), strength).cost[{15, 5}]), 0.8 + 0.2 * std::sqrt(2.0),
              1e-4);
}

TEST(ShortestPaths, EndThreeMetresFromThePath) {
  const ShortestPaths ways = waysOver(pathAt({{0, 5}}), Grid<float>(kField));
  const auto last = static_cast<std::int64_t>(std::floor(kMaxDistanceToPath / kField.resolution()));
  ASSERT_LT(last + 1, kField.width());
  EXPECT_NEAR((ways.cost[{last, 5}]), kMaxDistanceToPath, 0.1);
  EXPECT_GT((ways.cost[{last + 1, 5}]), 1e5F);
}

TEST(ShortestPaths, StopWhenAsked) {
  const std::atomic<bool> stop{true};
  EXPECT_GT((waysOver(pathAt({{5, 5}}), Grid<float>(kField), stop).cost[{6, 5}]), 1e5F);
}

}  // namespace
}  // namespace sfw
