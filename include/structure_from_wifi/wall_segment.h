#pragma once

#include "structure_from_wifi/types.h"

namespace sfw {

/// A straight piece of a wall, along an axis of the building.
struct WallSegment {
  Position from = Position::Zero();  ///< one end [m], map frame
  Position to = Position::Zero();    ///< the other end [m], map frame

  /// Probability that a wall stands there, as the network of walls expects it: 1 - exp(-n), n being
  /// the expected number of walls across the strip that is searched. In (0, 1).
  double confidence = 0.0;

  /// Whether the wall lies beyond the outermost passes of the robot. No ray can confirm such a
  /// wall, so its cells stay unknown in the map.
  bool is_outer = false;
};

}  // namespace sfw
