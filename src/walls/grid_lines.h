#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The rows of a grid, or its columns, as lines of cells. Code for walls along one axis serves the
/// other one too.
class GridLines {
 public:
  /// @param rows  whether the lines are rows; else they are columns
  GridLines(const GridGeometry& geometry, bool rows)
      : rows_(rows),
        count_(rows ? geometry.height() : geometry.width()),
        length_(rows ? geometry.width() : geometry.height()) {}

  std::int64_t count() const { return count_; }
  std::int64_t length() const { return length_; }

  /// The cell at a place on a line.
  Cell cell(std::int64_t line, std::int64_t at) const {
    return rows_ ? Cell{at, line} : Cell{line, at};
  }

 private:
  bool rows_;
  std::int64_t count_;
  std::int64_t length_;
};

}  // namespace sfw
