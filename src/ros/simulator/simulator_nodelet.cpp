#include "ros/simulator/simulator_nodelet.h"

#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/WifiScan.h>

#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "base/constants.h"
#include "ros/conversion/message_conversion.h"
#include "ros/conversion/parameters.h"
#include "ros/simulator/simulator_messages.h"
#include "ros/simulator/simulator_world.h"
#include "simulation/radio/noise_level.h"

namespace sfw {
namespace {

/// Stamp at which the simulated clock starts [s]. It is not 0, which means no time in ROS.
constexpr double kClockStart = 1000.0;

/// Wait after the first subscriber, in real time. Its connections for tf and clock take this long.
constexpr std::chrono::milliseconds kSettle{1000};

/// Share of a scan's period by which a scan may be early, so that rounding does not delay it by a
/// step.
constexpr double kRounding = 1e-9;

/// Whether the next scan is due at a time, after a number of scans.
bool isDue(double time_s, double rate_hz, std::uint64_t scans) {
  return time_s * rate_hz >= static_cast<double>(scans) - kRounding;
}

}  // namespace

SimulatorNodelet::~SimulatorNodelet() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  stop_signal_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void SimulatorNodelet::onInit() {
  try {
    loadParameters();
    makeWorld();
    advertise();
    thread_ = std::thread([this] { run(); });
    if (robot_) {  // last: callbacks may come before onInit returns
      constexpr std::uint32_t kQueue = 10;
      command_subscriber_ =
          getNodeHandle().subscribe("cmd_vel", kQueue, &SimulatorNodelet::receiveCommand, this);
    }
  } catch (const std::exception& error) {
    std::istringstream problems(error.what());
    for (std::string problem; std::getline(problems, problem);) {
      NODELET_ERROR_STREAM("The simulation cannot start: " << problem);
    }
  }
}

void SimulatorNodelet::loadParameters() {
  const YAML::Node settings = parametersOf(getPrivateNodeHandle());
  for (const std::string& name : unknownSimulatorSettings(settings)) {
    NODELET_WARN_STREAM("parameter " << name
                                     << " is not a setting of the simulation and is ignored");
  }
  config_ = simulatorConfigFromYaml(settings);
  if (const auto warning = oldNoiseLevelWarning(config_.noise)) {
    NODELET_WARN_STREAM("noise: " << *warning);
  }
}

void SimulatorNodelet::makeWorld() {
  const SimulatorWorld world = makeSimulatorWorld(config_);
  plan_ = toStates(world.plan);
  radio_.emplace(world.plan, asTransmitters(world.access_points), config_.signals.radio);
  error_.emplace(config_.signals);
  const Route route(world.way_points, config_.robot.max_speed_m_s,
                    config_.robot.max_yaw_rate_rad_s);
  if (config_.drive == "cmd_vel") {
    robot_.emplace(*plan_, route.poseAt(0.0), config_.robot);
  } else {
    route_ = route;
  }
}

void SimulatorNodelet::advertise() {
  ros::NodeHandle& node = getNodeHandle();
  if (config_.publish_clock != ros::Time::isSimTime()) {
    NODELET_WARN("publish_clock and /use_sim_time differ: set both to true or both to false");
  }
  start_ = config_.publish_clock ? ros::Time(kClockStart) : ros::Time(ros::WallTime::now().toSec());
  constexpr std::uint32_t kQueue = 100;
  constexpr bool kLatched = true;
  if (config_.publish_clock) {
    clock_publisher_ = node.advertise<rosgraph_msgs::Clock>("/clock", kQueue);
  }
  broadcaster_.emplace();
  odometry_publisher_ = node.advertise<nav_msgs::Odometry>("odom", kQueue);
  truth_publisher_ = node.advertise<nav_msgs::OccupancyGrid>("truth", 1, kLatched);
  if (config_.bumper == "contact_points") {
    points_publisher_ = node.advertise<sensor_msgs::PointCloud2>("contact_points", kQueue);
  } else {
    contact_publisher_ = node.advertise<std_msgs::Bool>("contact", kQueue, kLatched);
    contact_publisher_.publish(boolMessage(false));
  }
  finished_publisher_ = node.advertise<std_msgs::Bool>("finished", 1, kLatched);
  if (config_.laser.rate_hz > 0.0) {
    laser_publisher_ = node.advertise<sensor_msgs::LaserScan>("scan", kQueue);
  }
  scan_publisher_ = node.advertise<structure_from_wifi::WifiScan>("wifi_scan", kQueue);
  std_msgs::Header header;
  header.frame_id = config_.map_frame;
  header.stamp = start_;
  truth_publisher_.publish(toTrinaryGrid(*plan_, header));
  finished_publisher_.publish(boolMessage(false));
}

void SimulatorNodelet::receiveCommand(const geometry_msgs::Twist& twist) {
  if (!std::isfinite(twist.linear.x) || !std::isfinite(twist.angular.z)) {
    constexpr double kWarningPeriod = 10.0;  // [s]
    NODELET_WARN_THROTTLE(kWarningPeriod,
                          "a cmd_vel message is ignored: linear.x and angular.z must be finite");
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  command_ = DriveCommand{twist.linear.x, twist.angular.z};
}

void SimulatorNodelet::run() {
  const std::chrono::duration<double> step_time(1.0 / (config_.tf_rate_hz * config_.time_scale));
  const auto period = std::chrono::duration_cast<WallClock::duration>(step_time);
  WallClock::time_point due = WallClock::now();
  deadline_ = due + std::chrono::duration_cast<WallClock::duration>(
                        std::chrono::duration<double>(config_.start_delay_s));
  try {
    for (std::int64_t step = 0; waitUntil(due) && ros::ok(); ++step) {
      sendStep(step);
      due += period;
      if (config_.publish_clock) {
        // The simulated clock may lag: a burst after a pause of the machine would overrun
        // subscribers.
        due = std::max(due, WallClock::now());
      }
    }
  } catch (const std::exception& error) {
    NODELET_ERROR_STREAM("The simulation has stopped: " << error.what());
  }
}

bool SimulatorNodelet::waitUntil(WallClock::time_point time) {
  std::unique_lock<std::mutex> lock(mutex_);
  return !stop_signal_.wait_until(lock, time, [this] { return stop_; });
}

void SimulatorNodelet::sendStep(std::int64_t step) {
  const ros::Time stamp = start_ + ros::Duration(static_cast<double>(step) / config_.tf_rate_hz);
  const RobotPose pose = moveTo(step);
  if (config_.publish_clock) {
    rosgraph_msgs::Clock clock;
    clock.clock = stamp;
    clock_publisher_.publish(clock);
  }
  const auto transforms = transformMessages(config_, *error_, stamp, pose, driven_m_);
  broadcaster_->sendTransform(transforms);
  odometry_publisher_.publish(
      odometryMessage(odom_from_base_.value_or(transforms.back()), transforms.back()));
  odom_from_base_ = transforms.back();
  sendContact(stamp, pose);
  const double sent_s = static_cast<double>(step) / config_.tf_rate_hz;
  if (laser_publisher_ && isDue(sent_s, config_.laser.rate_hz, laser_scans_)) {
    sendLaserScan(stamp, pose);
  }
  if (!departure_ || finished_) {
    return;
  }
  const double driven_s = drivenTime(step);
  if (route_ && driven_s > route_->duration()) {
    // The drive ends at least a step after the last scan, so transforms before and after the scan
    // are sent.
    finish();
  } else if (isDue(driven_s, config_.scan_rate_hz, scans_)) {
    sendScan(stamp, pose);
  }
}

void SimulatorNodelet::sendContact(const ros::Time& stamp, const RobotPose& pose) {
  constexpr double kTurn = 0.2;  // [rad]
  const bool contact = robot_ && robot_->contact();
  // A robot that turns along a wall touches it at another point of its bumper.
  const bool turned =
      contact && std::abs(std::remainder(pose.yaw_rad - contact_yaw_rad_, 2.0 * kPi)) >= kTurn;
  if (contact != contact_ || turned) {
    contact_ = contact;
    contact_yaw_rad_ = pose.yaw_rad;
    if (points_publisher_) {
      sensor_msgs::PointCloud2 cloud =
          bumperCloud(pose, contact ? robot_->contact() : std::nullopt);
      cloud.header.stamp = stamp;
      cloud.header.frame_id = config_.base_frame;
      points_publisher_.publish(cloud);
    } else {
      contact_publisher_.publish(boolMessage(contact));
    }
  }
}

RobotPose SimulatorNodelet::moveTo(std::int64_t step) {
  if (robot_) {
    departure_ = 0;
    obeyCommands();
    robot_->step(step > 0 ? 1.0 / config_.tf_rate_hz : 0.0);
    driven_m_ = robot_->drivenDistance();
    return robot_->pose();
  }
  if (!departure_ && mayDepart()) {
    departure_ = step;
    NODELET_INFO("The drive starts and takes %.0f s of simulated time", route_->duration());
  }
  const double driven_s = drivenTime(step);
  driven_m_ = route_->drivenAt(driven_s);
  return route_->poseAt(driven_s);
}

void SimulatorNodelet::obeyCommands() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (command_) {
    robot_->command(*command_);
    command_.reset();
  }
}

double SimulatorNodelet::drivenTime(std::int64_t step) const {
  return departure_ ? static_cast<double>(step - *departure_) / config_.tf_rate_hz : 0.0;
}

void SimulatorNodelet::finish() {
  finished_ = true;
  finished_publisher_.publish(boolMessage(true));
  NODELET_INFO("The drive is finished: %llu scans sent", static_cast<unsigned long long>(scans_));
}

void SimulatorNodelet::sendScan(const ros::Time& stamp, const RobotPose& pose) {
  structure_from_wifi::WifiScan scan = scanMessage(*radio_, pose, scans_);
  scan.header.stamp = stamp;
  scan.header.frame_id = config_.base_frame;
  scan_publisher_.publish(scan);
  ++scans_;
}

void SimulatorNodelet::sendLaserScan(const ros::Time& stamp, const RobotPose& pose) {
  sensor_msgs::LaserScan scan = laserMessage(*plan_, pose, config_.laser);
  scan.header.stamp = stamp;
  scan.header.frame_id = config_.base_frame;
  laser_publisher_.publish(scan);
  ++laser_scans_;
}

bool SimulatorNodelet::mayDepart() {
  const WallClock::time_point now = WallClock::now();
  if (scan_publisher_.getNumSubscribers() > 0) {
    deadline_ = std::min(deadline_, now + kSettle);
  }
  return now >= deadline_;
}

}  // namespace sfw

PLUGINLIB_EXPORT_CLASS(sfw::SimulatorNodelet, nodelet::Nodelet)
