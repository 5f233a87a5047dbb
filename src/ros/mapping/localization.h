#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>
#include <tf2/buffer_core.h>

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "ros/conversion/observation.h"
#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/path_correction.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A pose of the antenna at a time.
struct LocatedPose {
  PathPose pose;
  std::optional<OdometryCorrection> correction;  ///< as of LocatedObservation
};

/// The readings and contacts of an observation, with their positions.
struct LocatedObservation {
  std::vector<Reading> readings;
  std::vector<Contact> contacts;
  std::optional<OdometryCorrection> correction;  ///< empty if tf has no frame of the odometry
  double sensor_height_m = 0.0;                  ///< in the map frame
  Eigen::Vector3d up_in_sensor = Eigen::Vector3d::UnitZ();  ///< the map's z axis
  std::vector<LocatedPose> way = {};  ///< from the observations before, by PathSampler
};

/// Looks up in tf where an observation was made. Never waits.
/// @param tf_error  gets tf's reason if there is no transform at the observation's stamp
/// @return nothing without a transform.
std::optional<LocatedObservation> locate(const Observation& observation, const RosSettings& config,
                                         const tf2::BufferCore& transforms, std::string& tf_error);

/// Looks up in tf where the antenna was. Never waits.
/// @return nothing without a transform.
std::optional<LocatedPose> locatePose(const ros::Time& stamp, const RosSettings& config,
                                      const tf2::BufferCore& transforms);

/// Looks up the latest position of the antenna and correction of the odometry, if tf has both.
std::optional<OdometryCorrection> latestCorrection(const RosSettings& config,
                                                   const tf2::BufferCore& transforms);

/// The heading of a rotation [rad].
double yawOf(const geometry_msgs::Quaternion& rotation);

/// A point of another frame, in the map frame [m].
Position inMap(const geometry_msgs::Transform& map_from_frame, const geometry_msgs::Point& point);

/// The settings of corrections that move the path.
PathCorrector::Tolerance jumpTolerance(const RosSettings& config);

}  // namespace sfw
