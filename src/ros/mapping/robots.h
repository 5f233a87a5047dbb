#pragma once

#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <vector>

#include "ros/conversion/observation.h"
#include "ros/conversion/ros_settings.h"
#include "ros/mapping/localization.h"
#include "ros/mapping/path_sampler.h"

namespace sfw {

/// The robots whose readings go into one map, each with its antenna in tf. Not thread-safe.
class Robots {
 public:
  /// @param settings  with one robot or several (antennaFrames)
  explicit Robots(const RosSettings& settings);

  /// The settings as if each robot were alone, in the order of antennaFrames.
  const std::vector<RosSettings>& settings() const { return settings_; }

  /// Looks up in tf where an observation was made, as sfw::locate does.
  ///
  /// A scan names its robot. Contacts belong to the robot whose antenna is nearest to their frame
  /// in the tree of tf; those of a bumper without direction are in the frame of its robot's
  /// antenna.
  std::optional<LocatedObservation> locate(const Observation& observation,
                                           const tf2::BufferCore& transforms,
                                           std::string& tf_error) const;

  /// Adds the way of its robot since the readings before (PathSampler) to an observation.
  void sampleWay(const tf2::BufferCore& transforms, LocatedObservation& observation);

  /// Forgets which part of the ways was sampled.
  void forgetWays();

  /// The latest correction of the odometry of each robot that has one.
  std::vector<OdometryCorrection> latestCorrections(const tf2::BufferCore& transforms) const;

  /// The index of the robot that made an observation.
  std::size_t robotOf(const Observation& observation, const tf2::BufferCore& transforms) const;

 private:
  std::string nameOf(std::size_t robot) const;

  std::vector<RosSettings> settings_;
  std::vector<PathSampler> samplers_;  // of each robot
};

/// Frames in a text: "robot1/base_link or robot2/base_link".
std::string antennaFramesText(const RosSettings& settings);

}  // namespace sfw
