#include "grid/outline_fill.h"

#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

/// The two directions in which the outline is cut into lines through cell centres.
enum class Lines { kRows, kColumns };

/// The crossings of the outline with each line, in cells along the line, ascending.
std::vector<std::vector<double>> crossings(const std::vector<Position>& outline,
                                           const GridGeometry& geometry, Lines lines) {
  const int along = lines == Lines::kRows ? 0 : 1;
  const int across = 1 - along;
  std::vector<std::vector<double>> at(
      static_cast<std::size_t>(lines == Lines::kRows ? geometry.height() : geometry.width()));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Position a = geometry.toCells(outline[i]);
    Position b = geometry.toCells(outline[(i + 1) % outline.size()]);
    if (a[across] > b[across]) {
      std::swap(a, b);
    }
    // The lower end belongs to an edge and the upper end does not. So a vertex on a line counts
    // once where the outline passes through it. It counts twice or never where the outline turns
    // back.
    const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(a[across] - 0.5)));
    for (std::size_t line = first; line < at.size(); ++line) {
      const double centre = static_cast<double>(line) + 0.5;
      if (centre >= b[across]) {
        break;
      }
      const double share = (centre - a[across]) / (b[across] - a[across]);
      at[line].push_back(a[along] + share * (b[along] - a[along]));
    }
  }
  for (std::vector<double>& line : at) {
    std::sort(line.begin(), line.end());
  }
  return at;
}

void fillRows(const std::vector<Position>& outline, Grid<CellState>& cells) {
  const std::vector<std::vector<double>> rows = crossings(outline, cells.geometry, Lines::kRows);
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t i = 0; i + 1 < rows[y].size(); i += 2) {
      const auto first = static_cast<std::int64_t>(std::ceil(rows[y][i] - 0.5));
      const auto end = static_cast<std::int64_t>(std::ceil(rows[y][i + 1] - 0.5));
      for (std::int64_t x = first; x < end; ++x) {
        cells[{x, static_cast<std::int64_t>(y)}] = CellState::kFree;
      }
    }
  }
}

/// A wall lies between two inner stretches. Without a centre in it, it would be lost.
void keepThinWalls(const std::vector<Position>& outline, Lines lines, Grid<CellState>& cells) {
  const std::vector<std::vector<double>> all = crossings(outline, cells.geometry, lines);
  for (std::size_t line = 0; line < all.size(); ++line) {
    for (std::size_t i = 1; i + 2 < all[line].size(); i += 2) {
      const double from = all[line][i];
      const double to = all[line][i + 1];
      if (std::ceil(from - 0.5) < std::ceil(to - 0.5)) {
        continue;  // it contains a centre
      }
      const auto at = static_cast<std::int64_t>(std::floor(0.5 * (from + to)));
      const auto of = static_cast<std::int64_t>(line);
      const Cell cell = lines == Lines::kRows ? Cell{at, of} : Cell{of, at};
      if (cells.geometry.contains(cell)) {
        cells[cell] = CellState::kOccupied;
      }
    }
  }
}

}  // namespace

Grid<CellState> fillOutline(const std::vector<Position>& outline, const GridGeometry& geometry) {
  Grid<CellState> cells(geometry);
  fillRows(outline, cells);
  keepThinWalls(outline, Lines::kRows, cells);
  keepThinWalls(outline, Lines::kColumns, cells);
  return cells;
}

}  // namespace sfw
