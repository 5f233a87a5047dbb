#pragma once

#include <geometry_msgs/Twist.h>
#include <nodelet/nodelet.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <tf2_ros/transform_broadcaster.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>

#include "ros/simulator/simulator_config.h"
#include "simulation/radio/radio_model.h"
#include "simulation/robot/route.h"
#include "simulation/robot/simulated_robot.h"
#include "simulation/simulated_recording.h"

namespace sfw {

/// Simulates a robot that drives through a floor plan and receives its access points.
///
/// The nodelet publishes tf (map -> odom -> base), `wifi_scan`, `truth` (the plan, latched),
/// `contact` and `finished` (std_msgs/Bool, latched, at each change; `contact` also after each turn
/// of 0.2 rad that goes on touching), if asked a laser `scan`, and,
/// with `publish_clock`, /clock. Each step sends the clock, then transforms, then the scan if one
/// is due. So a scan has the stamp of transforms that were sent before it; the next transforms
/// follow a step later.
///
/// A drive along a route starts when a node subscribes to the scans. Scans end with the drive;
/// clock and tf continue. With `drive` cmd_vel the robot obeys `cmd_vel` (geometry_msgs/Twist:
/// linear.x and angular.z) from the start. Walls stop it, and the drive has no end.
///
/// A thread of the nodelet runs the steps by the machine's clock, so a stopped simulated time does
/// not stop it. If a parameter cannot be used, the nodelet logs an error and advertises nothing.
class SimulatorNodelet : public nodelet::Nodelet {
 public:
  ~SimulatorNodelet() override;

 private:
  using WallClock = std::chrono::steady_clock;

  void onInit() override;

  /// @throw InputError if the parameters or the files that they name cannot be used.
  void loadParameters();
  void makeWorld();
  void advertise();

  void receiveCommand(const geometry_msgs::Twist& twist);

  void run();

  /// Waits for a point in time. Returns false as soon as the nodelet has to stop.
  bool waitUntil(WallClock::time_point time);

  /// Sends the messages of a step. Step n is n / tf_rate after the start.
  void sendStep(std::int64_t step);

  /// Sends a contact that begins or ends, and one that goes on after each turn of 0.2 rad.
  void sendContact(const ros::Time& stamp, const RobotPose& pose);

  /// Moves the robot to a step of its drive and returns its pose.
  RobotPose moveTo(std::int64_t step);
  void obeyCommands();

  void sendScan(const ros::Time& stamp, const RobotPose& pose);
  void sendLaserScan(const ros::Time& stamp, const RobotPose& pose);
  void finish();

  /// The time since the start of the drive [s].
  double drivenTime(std::int64_t step) const;

  /// Whether the drive may start: a subscriber is connected, or the wait for one is over.
  bool mayDepart();

  SimulatorConfig config_;
  std::optional<Grid<CellState>> plan_;
  std::optional<RadioModel> radio_;
  std::optional<PositionError> error_;
  std::optional<Route> route_;           // either this
  std::optional<SimulatedRobot> robot_;  // or this

  ros::Publisher clock_publisher_;
  ros::Publisher scan_publisher_;
  ros::Publisher laser_publisher_;  // unused without a laser
  ros::Publisher odometry_publisher_;
  ros::Publisher truth_publisher_;
  ros::Publisher contact_publisher_;  // this or the next one
  ros::Publisher points_publisher_;
  ros::Publisher finished_publisher_;
  std::optional<tf2_ros::TransformBroadcaster> broadcaster_;
  std::optional<geometry_msgs::TransformStamped> odom_from_base_;  // as last sent
  ros::Subscriber command_subscriber_;

  ros::Time start_;                        // stamp of step 0
  WallClock::time_point deadline_;         // the drive starts then at the latest
  std::optional<std::int64_t> departure_;  // the step at which it did start
  std::uint64_t scans_ = 0;                // sent so far
  std::uint64_t laser_scans_ = 0;          // sent so far
  double driven_m_ = 0.0;
  bool contact_ = false;
  double contact_yaw_rad_ = 0.0;  // of the robot at the last message
  bool finished_ = false;

  std::mutex mutex_;
  std::condition_variable stop_signal_;
  bool stop_ = false;                    // guarded by mutex_
  std::optional<DriveCommand> command_;  // guarded by mutex_; not yet obeyed
  std::thread thread_;
};

}  // namespace sfw
