#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds the nearest neighbours of a point among positions that are inserted one by one.
///
/// Positions are sorted into square cells, about four in each. A search goes outwards in rings of
/// cells. The result is exact. If a share s of evenly spread positions is inserted, a search visits
/// about `count` / (4 s) cells.
class NearestNeighbours {
 public:
  /// @param positions all that can be inserted [m], finite; must outlive this
  explicit NearestNeighbours(const std::vector<Position>& positions);

  /// Inserts the position with a number, so that searches find it.
  void enter(int number);

  /// The `count` nearest inserted positions, or all if there are fewer.
  /// @return squared distance [m2] and number of each, by distance, then by number; valid until the
  /// next call.
  const std::vector<std::pair<double, int>>& nearest(const Position& to, std::size_t count);

 private:
  std::int64_t cellOf(double coordinate, double least) const;
  void lookIn(std::int64_t x, std::int64_t y, const Position& to, std::size_t count);
  void lookInRing(std::int64_t x, std::int64_t y, std::int64_t ring, const Position& to,
                  std::size_t count);

  const std::vector<Position>& positions_;
  Position least_ = Position::Zero();
  double edge_ = 1.0;  // of a cell [m]
  std::int64_t width_ = 1;
  std::int64_t height_ = 1;
  std::vector<int> first_;                     // position in each cell, -1: none
  std::vector<int> next_;                      // position in the same cell, -1: none
  std::vector<std::pair<double, int>> found_;  // squared distance [m2] and number, in order
};

}  // namespace sfw
