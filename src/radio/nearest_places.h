#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds the nearest among places that are entered one by one.
///
/// Places lie in square cells, about four in each; searches go outwards in rings of cells. Exact. A
/// search among a share s of places spread evenly looks at about `count` / (4 s) cells.
class NearestPlaces {
 public:
  /// @param places  all that can be entered, finite; must outlive this
  explicit NearestPlaces(const std::vector<Position>& places);

  /// Makes the place of that number one to be found.
  void enter(int place);

  /// Numbers of the `count` nearest entered places, or of all if there are fewer, by distance, then
  /// by number. Valid until the next call.
  const std::vector<std::pair<double, int>>& nearest(const Position& to, std::size_t count);

 private:
  std::int64_t cellOf(double coordinate, double least) const;
  void lookIn(std::int64_t x, std::int64_t y, const Position& to, std::size_t count);
  void lookInRing(std::int64_t x, std::int64_t y, std::int64_t ring, const Position& to,
                  std::size_t count);

  const std::vector<Position>& places_;
  Position least_ = Position::Zero();
  double edge_ = 1.0;  // of a cell [m]
  std::int64_t width_ = 1;
  std::int64_t height_ = 1;
  std::vector<int> first_;                     // of each cell's places, -1: none
  std::vector<int> next_;                      // of each place in its cell
  std::vector<std::pair<double, int>> found_;  // squared distance [m2] and number, in order
};

}  // namespace sfw
