#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Result of the check whether poses drifted: signals at a revisited position must be the same.
struct DriftCheck {
  /// Mean squared difference of signals between passes less than 0.3 m apart, over that between
  /// passes 2 to 3 m apart, without the noise of readings. About 0.1 to 0.4 for good poses; near 1
  /// for poses that drifted.
  double ratio = 0.0;
  std::size_t returns = 0;  ///< stretches of 0.25 m to which the path returned

  bool suspect = false;  ///< the poses probably drifted
};

/// Compares the signals of each access point where the path returns (doc/method/checks.md).
///
/// @param samples  of each access point, by time
/// @return nothing if there are fewer than 20 returns after at least 10 m of driving, or if signals
/// differ by less than 2 dB between passes 2 to 3 m apart.
/// O(stretches^2), at most 2000 for each access point. Longer drives have longer stretches.
std::optional<DriftCheck> checkDrift(const std::vector<std::vector<Sample>>& samples);

}  // namespace sfw
