#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A segment on the grid's lattice, for a walk cell by cell.
///
/// Ends are snapped to 1/1024 cell, strictly inside their cells, so neither end lies on a border
/// and all later arithmetic is exact in integers. The cells from A to B are those from B to A. A
/// segment through a lattice corner steps diagonally in both directions.
/// Exact for cell coordinates below 2^19 in magnitude; points farther out are not allowed.
class Ray {
 public:
  static constexpr int kSubcellBits = 10;
  static constexpr std::int64_t kSubcells = std::int64_t{1} << kSubcellBits;  ///< of a cell's edge

  /// The sub-cell to which an end at a coordinate [cells] is snapped.
  static std::int64_t snapped(double cells);

  /// @param from,to  finite points [m] in the frame of `geometry`; they may lie outside the grid.
  Ray(const GridGeometry& geometry, const Position& from, const Position& to);

  /// Calls `visit(Cell)` for each crossed cell in order, both ends and cells outside the grid
  /// included. O(cells crossed).
  template <class Visitor>
  void forEachCell(Visitor&& visit) const {
    forEachCellWhile([&](Cell cell) {
      visit(cell);
      return true;
    });
  }

  /// Calls `visit(Cell)` as forEachCell does, until it returns false.
  template <class Visitor>
  void forEachCellWhile(Visitor&& visit) const;

 private:
  std::int64_t from_x_, from_y_, to_x_, to_y_;  // in sub-cells
};

template <class Visitor>
void Ray::forEachCellWhile(Visitor&& visit) const {
  const std::int64_t length_x = std::abs(to_x_ - from_x_);
  const std::int64_t length_y = std::abs(to_y_ - from_y_);
  const std::int64_t step_x = to_x_ < from_x_ ? -1 : 1;
  const std::int64_t step_y = to_y_ < from_y_ ? -1 : 1;
  Cell cell{from_x_ >> kSubcellBits, from_y_ >> kSubcellBits};
  const Cell last{to_x_ >> kSubcellBits, to_y_ >> kSubcellBits};

  // Distance to the next column and row border, both scaled by length_x * length_y so that
  // they compare as the ray's parameter does.
  const auto to_border = [](std::int64_t at, std::int64_t step) {
    const std::int64_t inside = at & (kSubcells - 1);
    return step > 0 ? kSubcells - inside : inside;
  };
  std::int64_t next_x = to_border(from_x_, step_x) * length_y;
  std::int64_t next_y = to_border(from_y_, step_y) * length_x;

  while (visit(cell) && cell != last) {
    const bool cross_x = next_x <= next_y;
    const bool cross_y = next_y <= next_x;
    if (cross_x) {
      cell.x += step_x;
      next_x += kSubcells * length_y;
    }
    if (cross_y) {
      cell.y += step_y;
      next_y += kSubcells * length_x;
    }
  }
}

}  // namespace sfw
