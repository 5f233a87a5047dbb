#pragma once

#include <optional>
#include <vector>

namespace sfw {

/// Ratings of what is free and of what is wall, by the truth. Walls should be rated higher.
struct Ratings {
  std::vector<double> free;
  std::vector<double> wall;
};

/// The chance that a wall is rated above what is free; ties count half (Mann and Whitney 1947).
/// Nothing if either kind is missing. O(n log n) of all ratings.
std::optional<double> areaUnderCurve(Ratings ratings);

}  // namespace sfw
