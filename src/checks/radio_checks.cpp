#include "checks/radio_checks.h"

#include <algorithm>
#include <cstddef>

namespace sfw {
namespace {

using Readings = ReadingRefs;

}  // namespace

std::vector<Bssid> findHeardAtOnePlace(const std::vector<AccessPoint>& table,
                                       const std::vector<Readings>& readings,
                                       const std::vector<PathPose>& path) {
  constexpr std::size_t kFewestReadings = 5;
  constexpr double kOnePlace = 1.0;    // [m]
  constexpr double kMuchLonger = 4.0;  // [m]
  Box driven;
  for (const PathPose& pose : path) {
    driven.extend(pose.antenna_in_map);
  }
  std::vector<Bssid> found;
  if (driven.isEmpty() || driven.diagonal().norm() < kMuchLonger) {
    return found;
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    Box heard;
    for (const Reading& reading : readings[i]) {
      heard.extend(reading.antenna_in_map);
    }
    if (readings[i].size() >= kFewestReadings && heard.diagonal().norm() < kOnePlace) {
      found.push_back(table[i].bssid);
    }
  }
  return found;
}

}  // namespace sfw
