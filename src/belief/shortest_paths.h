#pragma once

#include <atomic>
#include <cstddef>

#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Shortest paths, in cost, from the robot's path to each cell near it.
struct ShortestPaths {
  Grid<float> cost;          ///< [m]
  Grid<std::size_t> source;  ///< index of the cell of the robot's path where each begins
};

/// Finds the shortest paths by Dijkstra's algorithm over eight neighbours. A metre costs 1 plus 2
/// for each dB of wall strength there.
/// @param path            cells of the robot's path
/// @param distance_cells  to the path; cells beyond kMaxDistanceToPath are not visited
/// @param strength_db     of the wall in each cell
/// @param stop            polled; when it turns true the result is incomplete
/// O(cells log cells).
ShortestPaths shortestPathsFrom(const Mask& path, const Grid<double>& distance_cells,
                                const Grid<float>& strength_db, const std::atomic<bool>& stop);

}  // namespace sfw
