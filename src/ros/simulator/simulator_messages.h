#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/WifiScan.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ros/simulator/simulator_config.h"
#include "simulation/radio/radio_model.h"
#include "simulation/robot/route.h"
#include "simulation/simulated_recording.h"

namespace sfw {

std_msgs::Bool boolMessage(bool value);

/// Where the robot believes to be: map -> odom, which registration shifts a little, and odom ->
/// base, which drifts. The heading is exact.
/// @param driven_m  way driven so far
std::vector<geometry_msgs::TransformStamped> transformMessages(const SimulatorConfig& config,
                                                               const PositionError& error,
                                                               const ros::Time& stamp,
                                                               const RobotPose& pose,
                                                               double driven_m);

/// What the radio hears where the robot really is.
/// @param sample  number of the scan
structure_from_wifi::WifiScan scanMessage(const RadioModel& radio, const RobotPose& pose,
                                          std::uint64_t sample);

}  // namespace sfw
