#pragma once

#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The inside of a closed outline (even-odd) as free cells, judged at their centres, and as
/// occupied cells the walls in it that are too thin to hold a centre; all else unknown.
/// @param outline vertices [m] in the frame of `geometry`, the last joined to the first, all within
/// the grid; fewer than three have no inside.
/// O(cells + n log n), n being the rows and columns that the outline's edges cross in sum.
Grid<CellState> fillOutline(const std::vector<Position>& outline, const GridGeometry& geometry);

}  // namespace sfw
