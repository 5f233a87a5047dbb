#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Speed of a path: the median of its steps, those left out that hardly move or take no time [m/s];
/// 0 if there are no others.
double usualSpeed(const std::vector<PathPose>& path);

/// Whether the robot can have driven from one pose to another: at five times its usual speed [m/s],
/// or at 2 m/s if that is slower, but for 2 m that a correction of the path may move it by at once.
bool isReachable(const PathPose& from, const PathPose& to, double usual_speed);

/// Poses at which the robot cannot have been: its localisation lost it for a moment.
///
/// The path is cut where the next pose is not reachable. The piece of most poses is believed; and
/// from it on, both ways, each piece that the robot could have reached from what is believed so
/// far. So is one that lasts for 10 s or more, since a localisation that found its place moves all
/// that follows; the rest is stray.
/// @param path  in the order driven
/// @return for each pose whether it is stray. O(poses)
std::vector<bool> strayPoses(const std::vector<PathPose>& path);

}  // namespace sfw
