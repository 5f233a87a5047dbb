#pragma once

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Calls `visit(Cell)` for each cell of a rectangle of cells, row by row from the lowest y.
/// @param low,high  opposite corners, both included; nothing is visited if `low` exceeds `high`
template <class Visitor>
void forEachCell(Cell low, Cell high, Visitor&& visit) {
  Cell cell;
  for (cell.y = low.y; cell.y <= high.y; ++cell.y) {
    for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
      visit(cell);
    }
  }
}

/// Calls `visit(Cell)` for each cell of a grid in row-major order.
template <class Visitor>
void forEachCell(const GridGeometry& geometry, Visitor&& visit) {
  forEachCell(Cell{0, 0}, Cell{geometry.width() - 1, geometry.height() - 1}, visit);
}

}  // namespace sfw
