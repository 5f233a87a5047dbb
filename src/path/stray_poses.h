#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Returns the median speed of the steps of a path [m/s]. Steps that hardly move or take no time do
/// not count; without any other step the speed is 0.
double usualSpeed(const std::vector<PathPose>& path);

/// Returns whether the robot can have driven from one pose to another.
///
/// The limit is five times its usual speed, but at least 2 m/s, plus 2 m by which a correction of
/// the path may move it at once.
/// @param usual_speed_mps  as of usualSpeed
bool isReachable(const PathPose& from, const PathPose& to, double usual_speed_mps);

/// Finds the poses at which the robot cannot have been, because its localisation failed for a
/// moment.
///
/// The path is cut where the next pose is not reachable. The piece with the most poses is kept.
/// From there in both directions, each piece is kept that is reachable from the last one kept. A
/// piece that lasts for 10 s or more is kept too: a localisation that recovers moves the whole path
/// that follows. All other poses are stray.
/// @param path  in the order driven
/// @return for each pose whether it is stray. O(poses)
std::vector<bool> strayPoses(const std::vector<PathPose>& path);

}  // namespace sfw
