#pragma once

#include <nav_msgs/GetMap.h>
#include <nodelet/nodelet.h>
#include <octomap_msgs/GetOctomap.h>
#include <ros/callback_queue.h>
#include <ros/service_server.h>
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
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "map_publishers.h"
#include "observation_queue.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Maps while the robot drives: scans and tf in, maps out.
///
/// Input callbacks only fill a queue. One thread owns the mapper: it places what waits in the
/// queue, infers, publishes and answers the services, so none of them needs a lock and no callback
/// of the nodelet manager waits for any of them. Topics, services and parameters: README.md.
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
  void subscribe();

  // Input, in the manager's threads.
  void receiveScan(const structure_from_wifi::WifiScan& scan);
  void receiveConnection(const wireless_msgs::Connection& connection);
  void receiveContact(const std_msgs::Bool& contact);
  void receiveContactPoints(const sensor_msgs::PointCloud2& cloud);

  // All below in the mapping thread.
  void run();
  void step();
  void noticeTimeJump(const ros::Time& now);
  void placeObservations(const ros::Time& now);
  /// Publishes the map of all that is placed. @return false if stopped meanwhile.
  bool publishMap();

  bool serveMap(nav_msgs::GetMap::Response& response);
  bool serveOctomap(bool binary, octomap_msgs::GetOctomap::Response& response);
  bool saveMap(const structure_from_wifi::SaveMap::Request& request,
               structure_from_wifi::SaveMap::Response& response);
  bool reset(std_srvs::Trigger::Response& response);

  Config config_;
  std::vector<AccessPoint> access_points_;
  std::optional<Mapper> mapper_;
  std::optional<ObservationQueue> queue_;
  std::optional<MapPublishers> publishers_;

  std::optional<tf2_ros::Buffer> transforms_;
  std::optional<tf2_ros::TransformListener> transform_listener_;
  std::vector<ros::Subscriber> subscribers_;

  ros::CallbackQueue service_calls_;  // outlives the servers that use it
  std::vector<ros::ServiceServer> servers_;

  ros::Time last_now_;
  ros::SteadyTime next_publication_;
  bool changed_ = false;  // since the last publication
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace sfw
