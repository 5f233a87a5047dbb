#pragma once

#include <vector>

#include "base/reading_refs.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds access points with several readings, but all within a metre of a path that is much longer.
/// @param readings  of each access point, by stamp
/// O(readings)
std::vector<Bssid> findHeardAtOnePlace(const std::vector<AccessPoint>& table,
                                       const std::vector<ReadingRefs>& readings,
                                       const std::vector<PathPose>& path);

}  // namespace sfw
