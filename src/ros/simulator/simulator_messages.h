#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/WifiScan.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ros/simulator/simulator_config.h"
#include "simulation/radio/radio_model.h"
#include "simulation/robot/route.h"
#include "simulation/simulated_recording.h"

namespace sfw {

/// A message with a truth value.
std_msgs::Bool boolMessage(bool value);

/// The transforms of the reported pose: map -> odom with the registration's error, and odom -> base
/// with the drift. The heading is exact.
/// @param pose      true pose, map frame
/// @param driven_m  distance driven so far
std::vector<geometry_msgs::TransformStamped> transformMessages(const SimulatorConfig& config,
                                                               const PositionError& error,
                                                               const ros::Time& stamp,
                                                               const RobotPose& pose,
                                                               double driven_m);

/// The odometry of a robot between two transforms odom -> base: the later pose, and the mean
/// velocity between them in the frame of the base. It is 0 if both have the same stamp.
nav_msgs::Odometry odometryMessage(const geometry_msgs::TransformStamped& before,
                                   const geometry_msgs::TransformStamped& now);

/// The cloud of a bumper: the point that it touches; empty if there is none.
/// @param pose   true pose, map frame
/// @param point  true point [m], map frame
sensor_msgs::PointCloud2 bumperCloud(const RobotPose& pose, const std::optional<Position>& point);

/// What a laser scanner sees at the robot's true pose; infinity where nothing is in range.
/// @param pose  true pose, map frame
sensor_msgs::LaserScan laserMessage(const Grid<CellState>& plan, const RobotPose& pose,
                                    const LaserConfig& config);

/// A scan of the radio at the robot's true pose.
/// @param pose    true pose, map frame
/// @param sample  number of the scan
structure_from_wifi::WifiScan scanMessage(const RadioModel& radio, const RobotPose& pose,
                                          std::uint64_t sample);

}  // namespace sfw
