#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Whether two readings of one radio have one stamp.
inline bool isStampedAlike(const Reading& a, const Reading& b) {
  return a.stamp_ns == b.stamp_ns && a.bssid == b.bssid;
}

/// The first of each radio at each stamp.
/// @param readings  by stamp and bssid, of one stamp the strongest first
inline std::vector<Reading> strongestOfEachStamp(std::vector<Reading> readings) {
  readings.erase(std::unique(readings.begin(), readings.end(), isStampedAlike), readings.end());
  return readings;
}

/// How many of the others were heard at another place than the strongest.
/// @param readings  as for strongestOfEachStamp
inline std::size_t countStampedAlike(const std::vector<Reading>& readings) {
  std::size_t count = 0;
  std::size_t strongest = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    if (!isStampedAlike(readings[strongest], readings[i])) {
      strongest = i;
    } else if (readings[strongest].antenna_in_map != readings[i].antenna_in_map) {
      ++count;
    }
  }
  return count;
}

}  // namespace sfw
