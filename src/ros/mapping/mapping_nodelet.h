#pragma once

#include <nav_msgs/GetMap.h>
#include <nodelet/nodelet.h>
#include <octomap_msgs/GetOctomap.h>
#include <ros/callback_queue.h>
#include <ros/service_server.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <structure_from_wifi/SaveMap.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <wireless_msgs/Connection.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ros/mapping/map_publishers.h"
#include "ros/mapping/observation_queue.h"
#include "ros/mapping/shared_mapper.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/map_notes.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Maps while the robot drives: scans and tf in, maps out.
///
/// Input callbacks only fill a queue. One thread places what waits in the queue and gives quick
/// answers; another one infers from a copy, publishes and does all that takes its time. So no
/// callback of the nodelet manager waits for either, and placing goes on while a map is inferred.
/// Topics, services and parameters: doc/interfaces.md.
class MappingNodelet : public nodelet::Nodelet {
 public:
  ~MappingNodelet() override;

 private:
  /// Never throws: a nodelet that throws here takes its manager down. With parameters that cannot
  /// be used it names each one and advertises nothing.
  void onInit() override;

  /// @throw InputError
  void loadParameters();
  void advertise();
  void advertiseServices();
  void subscribe();

  // Input, in the manager's threads.
  void receiveScan(const structure_from_wifi::WifiScan& scan);
  void receiveConnection(const wireless_msgs::Connection& connection);
  void receiveContact(const std_msgs::Bool& contact);
  void receiveContactPoints(const sensor_msgs::PointCloud2& cloud);

  /// Warns, on a timer, as long as nothing comes.
  void warnNoInput();

  /// Answers the calls in a queue and takes steps in between until the nodelet ends.
  void run(ros::CallbackQueue& calls, void (MappingNodelet::*step)());

  // In the placing thread.
  void stepPlacing();
  void noticeTimeJump(const ros::Time& now);
  bool serveMap(nav_msgs::GetMap::Response& response);
  bool reset(std_srvs::Trigger::Response& response);

  // In the mapping thread.
  void stepMapping();
  /// A map, its data, and the findings about them.
  struct Mapping {
    SharedMapper::Copy copy;
    std::shared_ptr<const Snapshot> snapshot;  ///< nullptr if the nodelet stops
    DataFindings findings;
  };
  enum class Checks { kChanged, kAll };
  /// Makes a map, checks its data, and publishes both unless a reset came in between.
  Mapping publishMap(Checks checks);
  /// Logs each fault once, until the next reset.
  void reportFaults(const std::vector<MapNote>& notes);
  bool serveOctomap(bool binary, octomap_msgs::GetOctomap::Response& response);
  bool saveMap(const structure_from_wifi::SaveMap::Request& request,
               structure_from_wifi::SaveMap::Response& response);

  // In both.
  void placeObservations();
  void warnOfLosses(const ObservationQueue::Outcome& outcome);

  Config config_;
  std::vector<AccessPoint> access_points_;
  std::optional<SharedMapper> mapper_;
  std::optional<ObservationQueue> queue_;
  std::optional<MapPublishers> publishers_;

  std::optional<tf2_ros::Buffer> transforms_;
  std::unique_ptr<tf2_ros::TransformListener> transform_listener_;
  std::vector<ros::Subscriber> subscribers_;

  ros::CallbackQueue quick_calls_, slow_calls_;  // outlive the servers that use them
  std::vector<ros::ServiceServer> servers_;

  std::mutex placing_;     // held while what the queue holds goes to the mapper
  std::mutex publishing_;  // held while a map is published; a reset is one step to it
  ros::Time last_now_;
  ros::SteadyTime next_publication_;
  DataChecker checker_;  // in the mapping thread, as is the next
  std::set<std::pair<MapNote::Kind, std::string>> reported_faults_;  // faults, since the last reset
  std::atomic<bool> clear_reported_{false};
  std::atomic<bool> received_{false};  // anything from a radio
  ros::SteadyTimer silence_timer_;
  std::optional<OdometryCorrection>
      last_map_correction_;           // the last that tf said when a map was made
  std::atomic<bool> changed_{false};  // since the last map was made
  std::atomic<bool> stop_{false};
  std::thread placing_thread_, mapping_thread_;
};

}  // namespace sfw
