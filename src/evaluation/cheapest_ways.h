#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The cheapest ways from a cell to others, over the edges and corners of cells.
///
/// A step costs its length [cells] times the mean of both cells' costs. Of ways of equal cost one
/// is chosen deterministically. The search ends when it has reached all goals.
/// O(cells reached log cells reached).
class CheapestWays {
 public:
  /// @param cost_of_cell  for each cell of the grid; nothing enters a cell whose cost is not
  /// positive
  /// @param start,goals   cells of the grid
  CheapestWays(const Grid<double>& cost_of_cell, Cell start, const std::vector<Cell>& goals);

  /// The cost of the way to a goal; nothing if there is no way.
  std::optional<double> costTo(Cell goal) const;

  /// The cells of the way to a goal, from the start on; empty if there is no way.
  std::vector<Cell> to(Cell goal) const;

 private:
  void search(const Grid<double>& cost_of_cell, Cell start, const std::vector<Cell>& goals);

  Grid<double> cost_;
  Grid<std::uint8_t> arrived_by_;  // index of the last step to a cell
};

/// The length of a way [cells].
double lengthOf(const std::vector<Cell>& way);

}  // namespace sfw
