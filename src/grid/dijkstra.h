#pragma once

#include <algorithm>
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

/// Dijkstra's search if every step has a least cost: it settles the same cells in the same order,
/// in a third of the time.
///
/// Cells wait in buckets, each for a range of costs that is narrower than a step. So no cell joins
/// a bucket while its cells are settled, and a bucket is sorted once (Dial 1969).
class BucketDijkstra {
 public:
  /// @param cost        of each cell so far; must outlive this
  /// @param least_step  positive; a cell that is lowered costs at least so much more than the one
  ///                    that was settled last
  BucketDijkstra(Grid<float>& cost, float least_step) : cost_(cost), width_(0.5F * least_step) {}

  /// Sets the cost of a contained cell if it is lower than before.
  /// @param cost  not negative; memory grows with the highest one, in steps
  /// @return whether it was.
  bool lower(Cell cell, float cost) {
    const std::size_t index = cost_.geometry.index(cell);
    if (!(cost < cost_.cells[index])) {
      return false;
    }
    cost_.cells[index] = cost;
    const auto bucket = static_cast<std::size_t>(cost / width_);
    if (bucket >= buckets_.size()) {
      buckets_.resize(bucket + 1);
    }
    buckets_[bucket].push_back({cost, index});
    return true;
  }

  /// The next settled cell; nothing once no cell is left.
  std::optional<Cell> settle() {
    for (; bucket_ < buckets_.size(); ++bucket_, next_ = 0) {
      std::vector<Entry>& entries = buckets_[bucket_];
      if (next_ == 0) {
        std::sort(entries.begin(), entries.end());
      }
      while (next_ < entries.size()) {
        const auto [cost, index] = entries[next_++];
        if (!(cost > cost_.cells[index])) {  // otherwise the entry is outdated
          return cost_.geometry.cell(index);
        }
      }
    }
    return std::nullopt;
  }

 private:
  using Entry = std::pair<float, std::size_t>;

  Grid<float>& cost_;
  float width_;                              // of a bucket
  std::vector<std::vector<Entry>> buckets_;  // by cost
  std::size_t bucket_ = 0;                   // whose cells are settled now
  std::size_t next_ = 0;                     // entry of this bucket
};

}  // namespace sfw
