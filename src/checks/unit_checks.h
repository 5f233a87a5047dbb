#pragma once

#include <optional>
#include <vector>

#include "base/reading_refs.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds positions and stamps in other units than metres and seconds.
///
/// Speed, time between poses, extent and received power of a robot in a building span about two
/// decades each. The pair of units under which these four are likeliest is compared with metres
/// and seconds.
/// @param poses     every pose once, by stamp
/// @param power_dbm 95th percentile of rssi + 20 log10(distance to the access point); empty if no
///                  position is known
/// @return nothing if metres and seconds are plausible, or no other units are. O(poses)
std::optional<UnitFinding> checkUnits(const std::vector<PathPose>& poses,
                                      std::optional<double> power_dbm);

/// Calculates `power_dbm` for checkUnits from access points that stand near the path.
/// @param readings  of each access point; values that stand for "not heard" are left out already
/// @return nothing if fewer than 50 readings belong to such access points. O(readings)
std::optional<double> powerAtOneUnit(const std::vector<AccessPoint>& access_points,
                                     const std::vector<ReadingRefs>& readings);

}  // namespace sfw
