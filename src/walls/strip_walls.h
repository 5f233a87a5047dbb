#pragma once

#include <vector>

#include "grid/mask.h"

namespace sfw {

/// A wall in a strip between two passes of the robot, along an axis of the building.
struct StripWall {
  std::vector<Cell> cells;  ///< along the wall; successive ones share an edge
  double expected = 0.0;    ///< number of walls across the strip, mean along the wall
};

/// Settings of findStripWalls.
struct StripWallConfig {
  double least_expected = 0.7;  ///< a strip with fewer expected walls across it has none
  double widest_m = 4.0;        ///< wider strips are not searched
  double shortest_m = 0.5;      ///< shorter walls are not reported
  double extension_m = 0.8;     ///< an end grows by this much to meet another barrier
};

/// Finds walls between passes of the robot.
///
/// The densities along a row or column between two cells of the footprint add up to the expected
/// number of walls there. Where the sum passes a limit, one wall stands at its likeliest place. A
/// wall is spread over its strip, so no single cell would pass a limit.
/// @param footprint  of the robot, building frame
/// @param density    expected number of walls in each cell
/// @param free       cells believed to be free; the ends of walls grow through them only
/// O(cells), times the width of strips.
std::vector<StripWall> findStripWalls(const Mask& footprint, const Grid<float>& density,
                                      const Mask& free, const StripWallConfig& config);

}  // namespace sfw
