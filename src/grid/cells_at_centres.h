#pragma once

#include <cstdint>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The cells of one grid in which the centres of another grid's cells lie. Both grids have the same
/// axes, so each column is looked up once, and each row.
class CellsAtCentres {
 public:
  CellsAtCentres(const GridGeometry& centres_of, const GridGeometry& cells_of) {
    for (std::int64_t x = 0; x < centres_of.width(); ++x) {
      x_.push_back(cells_of.cellAt(centres_of.centre({x, 0})).x);
    }
    for (std::int64_t y = 0; y < centres_of.height(); ++y) {
      y_.push_back(cells_of.cellAt(centres_of.centre({0, y})).y);
    }
  }

  /// The cell at the centre of a cell; it may lie outside its grid.
  Cell operator[](Cell c) const {
    return {x_[static_cast<std::size_t>(c.x)], y_[static_cast<std::size_t>(c.y)]};
  }

 private:
  std::vector<std::int64_t> x_, y_;
};

}  // namespace sfw
