#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Everything that a recording offered to the mapper, as the checks examine it.
struct RecordingData {
  std::vector<Reading> accepted;  ///< by stamp, bssid and robot
  std::vector<Reading> refused;   ///< for their signal or position; the first ones of many

  /// The largest step back of a robot's stamps in order of arrival [ns].
  std::int64_t step_back_ns = 0;
};

}  // namespace sfw
