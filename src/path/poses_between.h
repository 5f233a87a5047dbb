#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Whether a pose comes before another one in the order driven. Robots come one after another.
bool isEarlier(const PathPose& a, const PathPose& b);

/// Every pose once, in the order driven.
std::vector<PathPose> sortedPath(std::vector<PathPose> poses);

/// Selects the poses that show how the robot drove from one reading to the next.
///
/// A pose is kept if it lies 0.1 m from the last one kept and from the next reading, and the robot
/// can have driven there from both readings. Next to a stray reading tf may have interpolated
/// towards its position, so no pose is kept there.
/// @param path   the poses of readings of one robot, as sortedPath returns them
/// @param stray  for each of these whether it is stray
/// @param poses  as sortedPath returns them; those before or after the path are left out
/// @return in the order driven. O(poses + path)
std::vector<PathPose> posesBetween(const std::vector<PathPose>& path,
                                   const std::vector<bool>& stray,
                                   const std::vector<PathPose>& poses);

}  // namespace sfw
