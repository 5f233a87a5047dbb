#pragma once

#include <optional>
#include <vector>

#include "localization/scan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Steps of the odometry from each scan to the next, in the frame of the odometry [m].
///
/// @param scans by time
/// @param poses of the odometry, in any order; poses are interpolated
/// @return one for each scan. Nothing for the first scan, and where a scan, or the one before, is
/// before the first pose, after the last one or in a gap of over 5 s.
/// O(poses log poses + scans log poses).
std::vector<std::optional<Position>> odometrySteps(const std::vector<Scan>& scans,
                                                   std::vector<PathPose> poses);

}  // namespace sfw
