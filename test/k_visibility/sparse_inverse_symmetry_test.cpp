#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/radio_scene.h"

namespace sfw {
namespace {

using test::coarseSettings;
using test::inferred;

constexpr double kSide = 24.0;

/// A walk about a square of `kSide` metres with counts at random. Positions are n/64 + 1/256, so
/// that neither they nor the middles between them lie on a border of cells, and all sums are exact.
std::vector<CountedPath> randomWalks(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&](double from, double to) {
    const auto span = static_cast<std::uint32_t>((to - from) * 64.0);
    return from + static_cast<double>(random() % span) / 64.0 + 1.0 / 256.0;
  };
  std::vector<CountedPath> walks(2);
  for (CountedPath& walk : walks) {
    walk.access_point = {coordinate(2.0, kSide - 2.0), coordinate(2.0, kSide - 2.0)};
    Position at(coordinate(6.0, 18.0), coordinate(6.0, 18.0));
    for (int i = 0; i < 80; ++i) {
      walk.poses.push_back({at, static_cast<int>(random() % 3)});
      at += Position(coordinate(-0.6, 0.6), coordinate(-0.6, 0.6)) - Position(1, 1) / 256.0;
      at = at.cwiseMax(1.0 / 256.0).cwiseMin(kSide - 1.0 + 1.0 / 256.0);
    }
  }
  return walks;
}

/// Compares the map of a world moved by `move_point` with the map of the world itself.
template <class MovePoint>
void expectMovedMap(MovePoint&& move_point) {
  SparseInverseConfig settings = coarseSettings();
  settings.max_gap_m = 2.0;
  const GridGeometry geometry(1.0, {0, 0}, static_cast<std::int64_t>(kSide),
                              static_cast<std::int64_t>(kSide));
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    const std::vector<CountedPath> walks = randomWalks(seed);
    std::vector<CountedPath> moved = walks;
    for (CountedPath& walk : moved) {
      walk.access_point = move_point(walk.access_point);
      for (CountedPose& pose : walk.poses) {
        pose.antenna_in_map = move_point(pose.antenna_in_map);
      }
    }
    const Grid<float> map = inferred(geometry, walks, settings);
    const Grid<float> map_of_moved = inferred(geometry, moved, settings);
    for (std::int64_t y = 0; y < geometry.height(); ++y) {
      for (std::int64_t x = 0; x < geometry.width(); ++x) {
        const Cell there = geometry.cellAt(move_point(geometry.centre({x, y})));
        ASSERT_NEAR((map[{x, y}]), map_of_moved[there], 1e-6) << "seed " << seed;
      }
    }
  }
}

TEST(Symmetry, AMirroredWorldGivesAMirroredMap) {
  expectMovedMap([](const Position& p) { return Position(kSide - p.x(), p.y()); });
  expectMovedMap([](const Position& p) { return Position(p.x(), kSide - p.y()); });
}

TEST(Symmetry, ARotatedWorldGivesARotatedMap) {
  expectMovedMap([](const Position& p) { return Position(kSide - p.y(), p.x()); });
}

TEST(Symmetry, APathDrivenBackwardsGivesTheSameMap) {
  SparseInverseConfig settings = coarseSettings();
  settings.max_gap_m = 2.0;
  const GridGeometry geometry(1.0, {0, 0}, 24, 24);
  const std::vector<CountedPath> walks = randomWalks(9);
  std::vector<CountedPath> backwards = walks;
  for (CountedPath& walk : backwards) {
    std::reverse(walk.poses.begin(), walk.poses.end());
  }
  const Grid<float> map = inferred(geometry, walks, settings);
  const Grid<float> again = inferred(geometry, backwards, settings);
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    ASSERT_NEAR(map.cells[i], again.cells[i], 1e-6);
  }
}

}  // namespace
}  // namespace sfw
