#pragma once

#include <algorithm>
#include <cstdint>

#include "grid/for_each_cell.h"
#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The value of a grid at a point [m].
/// @param elsewhere  for points outside the grid
template <class T>
T valueAt(const Grid<T>& grid, const Position& point, const T& elsewhere) {
  // Uses floating point, because a grid may lie too far away for integer numbers of cells.
  const Position at = grid.geometry.toCells(point);
  const bool inside = at.x() >= 0.0 && at.y() >= 0.0 &&
                      at.x() < static_cast<double>(grid.geometry.width()) &&
                      at.y() < static_cast<double>(grid.geometry.height());
  return inside ? grid[{static_cast<std::int64_t>(at.x()), static_cast<std::int64_t>(at.y())}]
                : elsewhere;
}

/// The value that a grid of any resolution has at each centre of the lattice's cells.
/// @param elsewhere  for centres outside the grid
template <class T>
Grid<T> sampled(const Grid<T>& grid, const GridGeometry& lattice, const T& elsewhere) {
  Grid<T> samples(lattice, elsewhere);
  forEachCell(lattice, [&](Cell c) { samples[c] = valueAt(grid, lattice.centre(c), elsewhere); });
  return samples;
}

/// The cells of one state.
inline Mask cellsOfState(const Grid<CellState>& grid, CellState state) {
  Mask mask(grid.geometry);
  std::transform(grid.cells.begin(), grid.cells.end(), mask.cells.begin(),
                 [state](CellState s) { return static_cast<std::uint8_t>(s == state); });
  return mask;
}

}  // namespace sfw
