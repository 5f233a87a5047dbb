#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <nodelet/nodelet.h>
#include <ros/callback_queue.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <ros/timer.h>
#include <ros/wall_timer.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exploration/pilot.h"
#include "exploration/way_driver.h"
#include "ros/exploration/exploration_messages.h"
#include "ros/exploration/exploration_settings.h"
#include "ros/exploration/move_base_driver.h"

namespace sfw {

/// Drives a robot through an unknown building, so that the mapper learns it.
///
/// It reads the mapper's topics, tf and the bumpers, and drives by `cmd_vel` or by move_base. One
/// thread does everything, so that no callback of the nodelet manager waits for the choice of a
/// goal. Topics, services and parameters: doc/interfaces.md. If a parameter cannot be used, the
/// nodelet logs an error and advertises nothing.
class ExplorationNodelet : public nodelet::Nodelet {
 public:
  ~ExplorationNodelet() override;

 private:
  void onInit() override;
  void makeDriver(const ros::NodeHandle& node);
  void connect(ros::NodeHandle& node, ros::NodeHandle& own);

  void takeGrid(nav_msgs::OccupancyGrid::ConstPtr& newest,
                const nav_msgs::OccupancyGrid::ConstPtr& message, const char* topic);
  void takeContact(const std_msgs::Bool& contact);
  void takeContactPoints(const sensor_msgs::PointCloud2::ConstPtr& cloud);

  bool start(std_srvs::Trigger::Response& response);
  bool stop(std_srvs::Trigger::Response& response);

  void tick();
  void step();
  std::optional<RobotPose> pose();
  std::optional<Position> touchedPoint(const RobotPose& pose) const;
  void drive(bool moving);
  void announce();
  void describe(diagnostic_updater::DiagnosticStatusWrapper& status) const;

  ExplorationSettings settings_;
  ros::CallbackQueue queue_;
  std::optional<tf2_ros::Buffer> transforms_;
  std::optional<tf2_ros::TransformListener> listener_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Publisher commands_, markers_, finished_;
  ros::Timer timer_;
  ros::WallTimer diagnostics_timer_;
  std::optional<diagnostic_updater::Updater> diagnostics_;

  std::unique_ptr<WayDriver> way_driver_;
  std::unique_ptr<MoveBaseDriver> move_base_;
  std::optional<Pilot> pilot_;

  bool active_ = false;
  bool commanding_ = false;     // the last command was no stop
  std::string waits_for_;       // why nothing happens; empty: nothing is missing
  std::string announced_goal_;  // to log each goal once
  bool announced_end_ = false;
  MapMessages map_;
  bool new_map_ = false;
  bool contact_ = false;
  std::optional<Position> contact_point_;  // in the robot's frame [m]
  ros::Time contact_point_at_;

  std::optional<ros::AsyncSpinner> spinner_;  // last: its thread uses all of the above
};

}  // namespace sfw
