#pragma once

#include <vector>

#include "grid/mask.h"

namespace sfw {

/// A wall beside the way of the robot, along an axis of the building.
struct StripWall {
  std::vector<Cell> cells;  ///< along the wall; successive ones share an edge
  double expected = 0.0;    ///< number of walls across the strip, mean along the wall
  bool is_outer = false;    ///< beyond the outermost passes, so that no ray can confirm it
};

/// Settings of findStripWalls.
struct StripWallConfig {
  double least_expected = 0.7;          ///< a strip with fewer expected walls across it has none
  double most_expected_if_open = 0.35;  ///< a strip with fewer expected walls is open
  double widest_m = 4.0;     ///< a wider gap between passes counts as two sides without a pass
  double beyond_m = 1.5;     ///< where no other pass follows, walls are searched this far
  double shortest_m = 0.5;   ///< shorter walls are not reported
  double extension_m = 0.8;  ///< an end grows by this much to meet another barrier
};

/// What the strips beside the way of the robot hold.
struct StripFindings {
  std::vector<StripWall> walls;
  Mask open;  ///< cells between two passes, in strips without a wall
};

/// Finds the walls between passes of the robot, and those beyond its outermost passes.
///
/// The densities along a row or column, from one cell of the footprint to the next, add up to the
/// expected number of walls there. Where the sum passes a limit, one wall stands at its likeliest
/// place. A wall is spread over its strip, so no single cell would pass a limit.
/// @param footprint  of the robot, building frame
/// @param density    expected number of walls in each cell
/// @param free       cells believed to be free. The ends of walls between passes grow through them.
///                   Walls beyond passes stand outside of them.
/// O(cells), times the width of strips.
StripFindings findStripWalls(const Mask& footprint, const Grid<float>& density, const Mask& free,
                             const StripWallConfig& config);

}  // namespace sfw
