#pragma once

#include <vector>

#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Poses at which the robot cannot have been: its localisation lost it for a moment.
///
/// The path is cut where the robot would have had to go faster than 10 m/s, over more than 2 m. The
/// piece of most poses is believed; and from it on, both ways, each piece that the robot could have
/// reached from what is believed so far. So is one that lasts for 10 s or more, since a
/// localisation that found its place moves all that follows; the rest is stray.
/// @param path  in the order driven
/// @return for each pose whether it is stray. O(poses)
std::vector<bool> strayPoses(const std::vector<PathPose>& path);

}  // namespace sfw
