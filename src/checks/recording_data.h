#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/reading_refs.h"

namespace sfw {

/// Everything that a recording offered to the mapper, as the checks examine it. Another list holds
/// the readings.
struct RecordingData {
  ReadingRefs accepted;  ///< by stamp, bssid and robot
  ReadingRefs refused;   ///< for their signal or position; the first ones of many

  /// The largest step back of a robot's stamps in order of arrival [ns].
  std::int64_t step_back_ns = 0;
};

}  // namespace sfw
