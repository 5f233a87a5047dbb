#pragma once

#include <algorithm>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Distance from a point to the segment between two others, in the unit of their coordinates.
inline double distanceToSegment(const Position& point, const Position& from, const Position& to) {
  const Position along = to - from;
  const double length_squared = along.squaredNorm();
  const double share = length_squared > 0.0 ? (point - from).dot(along) / length_squared : 0.0;
  return (from + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

}  // namespace sfw
