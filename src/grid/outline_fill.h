#pragma once

#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Fills a closed outline (even-odd rule): cells whose centres lie inside become free.
///
/// Walls inside the outline that are too thin to contain a centre become occupied. All other cells
/// stay unknown.
/// @param outline  vertices [m] in the frame of `geometry`, the last joined to the first, all
/// within the grid; fewer than three have no inside. O(cells + n log n), n being the rows and
/// columns that the outline's edges cross in sum.
Grid<CellState> fillOutline(const std::vector<Position>& outline, const GridGeometry& geometry);

}  // namespace sfw
