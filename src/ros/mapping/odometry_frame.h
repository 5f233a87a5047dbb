#pragma once

#include <tf2/buffer_core.h>

#include <string>
#include <vector>

#include "ros/conversion/ros_settings.h"

namespace sfw {

/// The frames on the way from one frame to another in the tree of tf, both included. Empty if tf
/// does not connect them.
std::vector<std::string> framesBetween(const std::string& from, const std::string& to,
                                       const tf2::BufferCore& transforms);

/// The frame of the odometry: ros/odom_frame, or else the one that tf shows. That is the first
/// frame from the map to the antenna that moves in the map and in which the antenna moves.
/// @return "" if there is none. Never throws.
std::string odometryFrame(const RosSettings& config, const tf2::BufferCore& transforms);

}  // namespace sfw
