#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radio/radio_bins.h"

namespace sfw {

/// Whether a path comes back to where it says: the same place must sound the same.
struct DriftCheck {
  /// How much signals differ where the path comes back to within 0.3 m of a place, as a share of
  /// how much they differ where it passes at 2 to 3 m: mean squares, the noise of readings taken
  /// off. Some .1 to .4 where poses are good, near 1 where they are not: then 0.3 m means nothing.
  double ratio = 0.0;
  std::size_t returns = 0;  ///< stretches of 0.25 m that the path came back to

  bool suspect = false;  ///< the poses look as if they drifted
};

/// Looks for drift in the signals of each access point (doc/method/checks.md).
///
/// @param samples  of each access point, in the order heard
/// @return nothing if the readings do not tell: fewer than 20 returns after 10 m or more of way, or
/// signals that differ by less than 2 dB over 2 to 3 m.
/// O(stretches^2), at most 2000 of an access point: longer drives have longer stretches.
std::optional<DriftCheck> checkDrift(const std::vector<std::vector<Sample>>& samples);

}  // namespace sfw
