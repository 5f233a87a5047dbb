#pragma once

#include <vector>

#include "structure_from_wifi/path_correction.h"

namespace sfw {

/// Whether corrections can be those of an odometry by one localisation.
///
/// They are not if the antenna hardly moves in the frame while it drives: then the frame is fixed
/// to the robot. Nor if the frame goes to and fro between two places: then two programs publish its
/// transform, and none of its jumps is a loop closure.
/// @param corrections  by stamp
bool areOfOdometry(const std::vector<OdometryCorrection>& corrections,
                   const PathCorrector::Tolerance& tolerance);

}  // namespace sfw
