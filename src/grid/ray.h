#pragma once

#include <cmath>
#include <cstddef>
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

  /// At least the number of cells crossed.
  std::size_t mostCells() const {
    return static_cast<std::size_t>(std::abs((to_x_ >> kSubcellBits) - (from_x_ >> kSubcellBits)) +
                                    std::abs((to_y_ >> kSubcellBits) - (from_y_ >> kSubcellBits)) +
                                    1);
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

  const std::int64_t column = kSubcells * length_y;
  const std::int64_t row = kSubcells * length_x;
  while (visit(cell) && cell != last) {
    // Masks of all bits or none, as the processor cannot foresee which border comes next.
    const std::int64_t cross_x = -static_cast<std::int64_t>(next_x <= next_y);
    const std::int64_t cross_y = -static_cast<std::int64_t>(next_y <= next_x);
    cell.x += step_x & cross_x;
    next_x += column & cross_x;
    cell.y += step_y & cross_y;
    next_y += row & cross_y;
  }
}

}  // namespace sfw
