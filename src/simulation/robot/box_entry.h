#pragma once

#include <algorithm>
#include <limits>

#include "structure_from_wifi/types.h"

namespace sfw {

/// The distance [m] along a ray at which it enters a rectangle; infinity if it never does, and
/// negative if it starts inside. A ray along an edge does not enter.
/// @param direction  of length 1
inline double entryIntoBox(const Position& from, const Position& direction, const Box& box) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double entry = -kInfinity;
  double exit = kInfinity;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = box.min()[axis] - from[axis];
    const double high = box.max()[axis] - from[axis];
    if (direction[axis] == 0.0) {
      if (low >= 0.0 || high <= 0.0) {
        return kInfinity;
      }
      continue;
    }
    const double a = low / direction[axis];
    const double b = high / direction[axis];
    entry = std::max(entry, std::min(a, b));
    exit = std::min(exit, std::max(a, b));
  }
  if (entry < exit && exit > 0.0) {
    return entry;
  }
  return kInfinity;
}

}  // namespace sfw
