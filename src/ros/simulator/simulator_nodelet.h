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

/// A robot that drives through a floor plan and hears its access points.
///
/// Publishes tf (map -> odom -> base), `wifi_scan`, `truth` (the plan, latched), `contact` and
/// `finished` (std_msgs/Bool, latched, at each change) and, with `publish_clock`, /clock. Each step
/// sends the clock, then transforms, then the scan if one is due: a scan bears the stamp of
/// transforms that were sent before it, and the next ones follow a step later.
///
/// Along a route the drive starts when somebody subscribes to the scans; scans end with it, clock
/// and tf go on. With `drive` cmd_vel the robot obeys `cmd_vel` (geometry_msgs/Twist: linear.x and
/// angular.z) from the start, walls stop it, and nothing ever finishes.
///
/// One thread of its own does all this by the machine's clock, so a simulated time that stands
/// still holds nothing up. With parameters that cannot be used it says so and advertises nothing.
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

  /// Waits for a point in time; false as soon as the nodelet is to stop.
  bool waitUntil(WallClock::time_point time);

  /// Sends all that is due at a step; step n lies n / tf_rate after the start.
  void sendStep(std::int64_t step);

  /// Moves the robot on to a step of its drive and says where it is.
  RobotPose moveTo(std::int64_t step);
  void obeyCommands();

  void sendScan(const ros::Time& stamp, const RobotPose& pose);
  void finish();

  /// Since the drive started [s].
  double drivenTime(std::int64_t step) const;

  /// True once the drive may start: a listener has settled, or none came in time.
  bool mayDepart();

  SimulatorConfig config_;
  std::optional<Grid<CellState>> plan_;
  std::optional<RadioModel> radio_;
  std::optional<PositionError> error_;
  std::optional<Route> route_;           // either this
  std::optional<SimulatedRobot> robot_;  // or this

  ros::Publisher clock_publisher_;
  ros::Publisher scan_publisher_;
  ros::Publisher truth_publisher_;
  ros::Publisher contact_publisher_;
  ros::Publisher finished_publisher_;
  std::optional<tf2_ros::TransformBroadcaster> broadcaster_;
  ros::Subscriber command_subscriber_;

  ros::Time start_;                        // stamp of step 0
  WallClock::time_point deadline_;         // the drive starts then at the latest
  std::optional<std::int64_t> departure_;  // the step at which it did start
  std::uint64_t scans_ = 0;                // sent so far
  double driven_m_ = 0.0;
  bool contact_ = false;
  bool finished_ = false;

  std::mutex mutex_;
  std::condition_variable stop_signal_;
  bool stop_ = false;                    // guarded by mutex_
  std::optional<DriveCommand> command_;  // guarded by mutex_; not yet obeyed
  std::thread thread_;
};

}  // namespace sfw
