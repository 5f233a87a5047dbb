#pragma once

#include <vector>

#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds access points that have the same signals everywhere: the BSSIDs of one radio.
///
/// Only access points of similar mean signals are compared, each with ten others at most.
/// @param readings  of each access point, by stamp
/// O(access points x readings of one)
AliasFinding findAliases(const std::vector<AccessPoint>& table,
                         const std::vector<std::vector<Reading>>& readings);

/// Finds access points with several readings, but all within a metre of a path that is much longer.
/// O(readings)
std::vector<Bssid> findHeardAtOnePlace(const std::vector<AccessPoint>& table,
                                       const std::vector<std::vector<Reading>>& readings,
                                       const std::vector<PathPose>& path);

}  // namespace sfw
