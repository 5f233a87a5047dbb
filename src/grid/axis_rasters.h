#pragma once

#include <array>
#include <cstdint>

#include "grid/mask.h"

namespace sfw {

/// Rasters along a grid's own axes, for the straight walls of the building frame.

/// Means over the cells within `reach` of each in its row, or in its column; cells outside the grid
/// count as 0. Linear in cells.
Grid<float> rowMean(const Grid<float>& values, std::int64_t reach);
Grid<float> columnMean(const Grid<float>& values, std::int64_t reach);

/// Mean over the square of cells within `reach` of each cell in both axes; cells outside the grid
/// count as 0. Linear in cells.
Grid<float> boxMean(const Grid<float>& values, std::int64_t reach);

/// Closes a set with a square of cells within `reach` in both axes: gaps in which the square finds
/// no room are closed, and corners stay square. A gap of at most `reach` cells between the set and
/// the grid's edge is closed too. Linear in cells.
Mask closedWithSquare(const Mask& set, std::int64_t reach);

/// Distance from each cell to the nearest one of the set along each half axis [m], at most
/// `farthest`; in the order left, right, down, up. Linear in cells.
std::array<Grid<float>, 4> axisDistances(const Mask& set, float farthest);

}  // namespace sfw
