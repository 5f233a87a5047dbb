#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Dijkstra's search over the cells of a grid (1959).
///
/// The caller lowers the cost of the cells where the search starts, takes each settled cell, and
/// lowers the costs of its neighbours. Cells are settled by rising cost, and those of equal cost in
/// row-major order, so results are deterministic. O(lowered log lowered).
template <class Cost>
class Dijkstra {
 public:
  /// @param cost  of each cell so far; must outlive this
  explicit Dijkstra(Grid<Cost>& cost) : cost_(cost) {}

  /// Sets the cost of a contained cell if it is lower than before.
  /// @return whether it was.
  bool lower(Cell cell, Cost cost) {
    const std::size_t index = cost_.geometry.index(cell);
    if (!(cost < cost_.cells[index])) {
      return false;
    }
    cost_.cells[index] = cost;
    open_.emplace(cost, index);
    return true;
  }

  /// The next settled cell; nothing once no cell is left.
  std::optional<Cell> settle() {
    while (!open_.empty()) {
      const auto [cost, index] = open_.top();
      open_.pop();
      if (!(cost > cost_.cells[index])) {  // otherwise the entry is outdated
        return cost_.geometry.cell(index);
      }
    }
    return std::nullopt;
  }

 private:
  using Entry = std::pair<Cost, std::size_t>;

  Grid<Cost>& cost_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace sfw
