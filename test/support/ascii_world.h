#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw::test {

/// A grid from rows of characters, top row first.
template <class T, class Convert>
Grid<T> gridFrom(const std::vector<std::string>& rows, double resolution, Convert&& convert,
                 const Position& origin = Position::Zero()) {
  const auto width = static_cast<std::int64_t>(rows.front().size());
  const auto height = static_cast<std::int64_t>(rows.size());
  Grid<T> grid(GridGeometry(resolution, origin, width, height));
  for (std::int64_t y = 0; y < height; ++y) {
    const std::string& row = rows[static_cast<std::size_t>(height - 1 - y)];
    for (std::int64_t x = 0; x < width; ++x) {
      grid[{x, y}] = convert(row.at(static_cast<std::size_t>(x)));
    }
  }
  return grid;
}

/// A map: '.' is free, '#' is occupied, anything else is unknown.
inline Grid<CellState> world(const std::vector<std::string>& rows, double resolution = 0.05,
                             const Position& origin = Position::Zero()) {
  const auto state = [](char c) {
    return c == '.' ? CellState::kFree : c == '#' ? CellState::kOccupied : CellState::kUnknown;
  };
  return gridFrom<CellState>(rows, resolution, state, origin);
}

/// A mask: '#' is in the set, anything else is outside.
inline Mask mask(const std::vector<std::string>& rows) {
  return gridFrom<std::uint8_t>(rows, 1.0, [](char c) -> std::uint8_t { return c == '#'; });
}

/// The rows of a grid, top row first.
template <class T, class Convert>
std::vector<std::string> rowsOf(const Grid<T>& grid, Convert&& convert) {
  std::vector<std::string> rows;
  for (std::int64_t y = grid.geometry.height() - 1; y >= 0; --y) {
    std::string row;
    for (std::int64_t x = 0; x < grid.geometry.width(); ++x) {
      row += convert(grid[{x, y}]);
    }
    rows.push_back(row);
  }
  return rows;
}

inline std::vector<std::string> rowsOf(const Mask& mask) {
  return rowsOf(mask, [](std::uint8_t in) { return in != 0 ? '#' : '.'; });
}

inline std::vector<std::string> rowsOf(const Grid<CellState>& grid) {
  return rowsOf(grid, [](CellState state) {
    return state == CellState::kFree ? '.' : state == CellState::kOccupied ? '#' : '?';
  });
}

}  // namespace sfw::test
