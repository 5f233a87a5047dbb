#pragma once

#include <atomic>
#include <cstddef>

#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The cheapest way from the path to each judged cell.
struct ShortestPaths {
  Grid<float> cost;          ///< [m]
  Grid<std::size_t> source;  ///< index of the path's cell that it starts from
};

/// Dijkstra over eight neighbours; a metre costs 1 + 2 for each dB of wall strength there.
/// @param distance  to the path, in cells: none is judged beyond kMaxDistanceToPath
/// @param stop      polled; when it turns true the result is incomplete
/// O(cells log cells).
ShortestPaths shortestPathsFrom(const Mask& path, const Grid<double>& distance,
                                const Grid<float>& strength, const std::atomic<bool>& stop);

}  // namespace sfw
