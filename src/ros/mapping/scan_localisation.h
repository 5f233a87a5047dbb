#pragma once

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "localization/particle_filter.h"
#include "localization/radio_map.h"
#include "ros/conversion/observation.h"
#include "ros/conversion/ros_settings.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Publishes where the robot is by its radio alone, on `~localisation`.
///
/// A thread of its own learns a radio map from the readings of the mapper and follows the scans
/// with a particle filter. Scans need no transform, so a robot is found that has no pose in the
/// map. The transform of the antenna in the frame of the odometry helps where there is one.
/// Thread-safe.
class ScanLocalisation {
 public:
  /// @param transforms must outlive this
  ScanLocalisation(const ros::NodeHandle& private_node, const RosSettings& settings,
                   const tf2_ros::Buffer& transforms);
  ~ScanLocalisation();
  ScanLocalisation(const ScanLocalisation&) = delete;
  ScanLocalisation& operator=(const ScanLocalisation&) = delete;

  /// Takes the readings of a message. Contacts and other robots' readings are ignored. Never waits
  /// for the thread's work.
  void add(const std::vector<Observation>& observations);

  /// Gives the thread readings to learn from, if there are a fifth more than it knows. Those of the
  /// last 30 s are left out: a robot that maps must not find its own last readings.
  void learnFrom(const Mapper& mapper);

  /// Forgets the radio map.
  void forget();

  /// Forgets where the robot was: the clock jumped.
  void startAgain();

 private:
  /// What the thread has to learn from.
  struct Lesson {
    std::vector<Reading> readings;
    std::vector<AccessPoint> access_points;
  };

  void run();
  void noteFailure(const std::exception& error) noexcept;
  void learn(const Lesson& lesson);
  void follow(std::vector<Reading> readings);
  std::optional<Position> odometryAt(std::int64_t stamp_ns) const;
  void publish(std::int64_t stamp_ns, const PlaceEstimate& estimate);

  RosSettings settings_;
  const tf2_ros::Buffer& transforms_;
  ros::Publisher publisher_;

  std::mutex mutex_;  // around the next members, up to the thread's own
  std::condition_variable wake_;
  std::vector<Reading> heard_;  // since the last step; they have no position
  std::unique_ptr<Lesson> lesson_;
  std::size_t known_readings_ = 0;
  bool forget_ = false, start_again_ = false;

  // Of the thread.
  std::unique_ptr<RadioMap> map_;
  std::unique_ptr<ParticleFilter> filter_;
  std::optional<Position> odometry_;  // at the last scan

  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// The message for an estimate: yaw is unknown, so its variance is that of all directions.
geometry_msgs::PoseWithCovarianceStamped toPoseMessage(const PlaceEstimate& estimate,
                                                       const ros::Time& stamp,
                                                       const std::string& map_frame);

}  // namespace sfw
