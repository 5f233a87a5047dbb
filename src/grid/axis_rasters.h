#pragma once

#include <array>
#include <cstdint>

#include "grid/mask.h"

namespace sfw {

// Rasters along a grid's own axes, for walls along the axes of the building frame.

/// Mean over the cells within `reach` cells of each cell in its row. Cells outside the grid count
/// as 0. Linear in cells.
Grid<float> rowMean(const Grid<float>& values, std::int64_t reach);

/// Calculates the mean as rowMean does, but in each column.
Grid<float> columnMean(const Grid<float>& values, std::int64_t reach);

/// Mean over the square of cells within `reach` cells of each cell. Cells outside the grid count as
/// 0. Linear in cells.
Grid<float> boxMean(const Grid<float>& values, std::int64_t reach);

/// Morphological closing with a square of 2 reach + 1 cells: gaps too narrow for the square are
/// closed, and corners stay square. A gap of at most `reach` cells between the set and the grid's
/// edge is closed too. Linear in cells.
Mask closedWithSquare(const Mask& set, std::int64_t reach);

/// Distances from each cell to the nearest cell of the set to the left, right, below and above [m],
/// at most `farthest_m`. Linear in cells.
std::array<Grid<float>, 4> axisDistances(const Mask& set, float farthest_m);

}  // namespace sfw
