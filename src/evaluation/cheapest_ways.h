#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Finds the cheapest ways from a cell to others, over the edges and corners of cells.
///
/// A step costs its length [cells] times the mean of both cells' costs. Of ways of equal cost one
/// is chosen deterministically. A search ends when it has reached all goals. It reuses memory
/// between searches. Not thread-safe.
class CheapestWays {
 public:
  /// @param cost_of_cell  nothing enters a cell whose cost is not positive; must outlive this
  explicit CheapestWays(const Grid<double>& cost_of_cell);

  /// Searches from a cell of the grid to others. O(cells reached log cells reached).
  void search(Cell start, std::vector<Cell> goals);

  /// The cost of the way to a goal of the last search; nothing if there is no way.
  std::optional<double> costTo(Cell goal) const;

  /// The cells of the way to a goal of the last search, from the start on; empty if there is none.
  std::vector<Cell> to(Cell goal) const;

 private:
  const Grid<double>& cost_of_cell_;
  Grid<double> cost_;              // infinity where no search has been since the last reset
  Grid<std::uint8_t> arrived_by_;  // index of the last step to a cell
  std::vector<Cell> touched_;
};

/// The length of a way [cells].
double lengthOf(const std::vector<Cell>& way);

}  // namespace sfw
