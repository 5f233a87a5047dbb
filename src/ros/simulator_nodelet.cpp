#include "simulator_nodelet.h"

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/WifiScan.h>

#include <algorithm>
#include <cmath>
#include <pluginlib/class_list_macros.hpp>
#include <sstream>

#include "message_conversion.h"
#include "parameters.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_server.h"
#include "structure_from_wifi/plan.h"
#include "structure_from_wifi/reading_io.h"

namespace sfw {
namespace {

/// Stamp at which a clock of our own starts: not 0, which ROS takes for no time at all.
constexpr double kClockStart = 1000.0;

/// A robot stands still for this long once it has a listener, real time: connections for tf and
/// clock are still being made.
constexpr std::chrono::milliseconds kSettle{1000};

/// Share of a scan by which one may come early, so that rounding does not delay it by a step.
constexpr double kRounding = 1e-9;

geometry_msgs::TransformStamped transformMessage(const ros::Time& stamp, const std::string& parent,
                                                 const std::string& child, const RobotPose& pose) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = pose.position.x();
  message.transform.translation.y = pose.position.y();
  message.transform.rotation.z = std::sin(0.5 * pose.yaw_rad);
  message.transform.rotation.w = std::cos(0.5 * pose.yaw_rad);
  return message;
}

std_msgs::Bool boolMessage(bool value) {
  std_msgs::Bool message;
  message.data = value;
  return message;
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
    loadWorld();
    advertise();
    thread_ = std::thread([this] { run(); });
  } catch (const std::exception& error) {
    std::istringstream problems(error.what());
    for (std::string problem; std::getline(problems, problem);) {
      NODELET_ERROR_STREAM("The simulation cannot start: " << problem);
    }
  }
}

void SimulatorNodelet::loadWorld() {
  const ros::NodeHandle& parameters = getPrivateNodeHandle();
  XmlRpc::XmlRpcValue tree;
  parameters.getParam(parameters.getNamespace(), tree);
  const YAML::Node settings = toYaml(tree);
  for (const std::string& name : unknownSimulatorSettings(settings)) {
    NODELET_WARN_STREAM(name << " is not a setting of the simulation");
  }
  config_ = simulatorConfigFromYaml(settings);
  plan_ = readMap(config_.plan);
  const std::vector<Position> way_points = readWayPoints(config_.route);
  try {
    requireFree(*plan_, way_points, config_.robot_radius);
    route_.emplace(way_points, config_.speed, config_.yaw_rate);
  } catch (const InputError& error) {
    throw InputError(config_.route + ": " + error.what());
  }
  radio_.emplace(withMaterials(*plan_), asTransmitters(config_.access_points), config_.radio);
}

void SimulatorNodelet::advertise() {
  ros::NodeHandle& node = getNodeHandle();
  if (config_.publish_clock != ros::Time::isSimTime()) {
    NODELET_WARN("publish_clock and /use_sim_time should be both true or both false");
  }
  start_ = config_.publish_clock ? ros::Time(kClockStart) : ros::Time(ros::WallTime::now().toSec());
  constexpr std::uint32_t kQueue = 100;
  constexpr bool kLatched = true;
  if (config_.publish_clock) {
    clock_publisher_ = node.advertise<rosgraph_msgs::Clock>("/clock", kQueue);
  }
  broadcaster_.emplace();
  truth_publisher_ = node.advertise<nav_msgs::OccupancyGrid>("truth", 1, kLatched);
  finished_publisher_ = node.advertise<std_msgs::Bool>("finished", 1, kLatched);
  scan_publisher_ = node.advertise<structure_from_wifi::WifiScan>("wifi_scan", kQueue);
  std_msgs::Header header;
  header.frame_id = config_.map_frame;
  header.stamp = start_;
  truth_publisher_.publish(toTrinaryGrid(*plan_, header));
  finished_publisher_.publish(boolMessage(false));
}

void SimulatorNodelet::run() {
  const std::chrono::duration<double> step_time(1.0 / (config_.tf_rate * config_.time_scale));
  const auto period = std::chrono::duration_cast<WallClock::duration>(step_time);
  WallClock::time_point due = WallClock::now();
  deadline_ = due + std::chrono::duration_cast<WallClock::duration>(
                        std::chrono::duration<double>(config_.start_delay));
  try {
    for (std::int64_t step = 0; waitUntil(due) && ros::ok(); ++step) {
      sendStep(step);
      due += period;
      if (config_.publish_clock) {
        // Our own clock may lag: after a pause of the machine a burst would overrun the listeners.
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
  if (!departure_ && mayDepart()) {
    departure_ = step;
    NODELET_INFO("The drive takes %.0f s of simulated time", route_->duration());
  }
  const ros::Time stamp = start_ + ros::Duration(static_cast<double>(step) / config_.tf_rate);
  const double driven_s =
      departure_ ? static_cast<double>(step - *departure_) / config_.tf_rate : 0.0;
  const RobotPose pose = route_->poseAt(driven_s);
  if (config_.publish_clock) {
    rosgraph_msgs::Clock clock;
    clock.clock = stamp;
    clock_publisher_.publish(clock);
  }
  sendTransforms(stamp, pose);
  if (!departure_ || finished_) {
    return;
  }
  if (driven_s > route_->duration()) {
    // A step after the last scan at the earliest, so transforms on both sides of it are out.
    finish();
  } else if (driven_s * config_.scan_rate >= static_cast<double>(scans_) - kRounding) {
    sendScan(stamp, pose);
  }
}

void SimulatorNodelet::finish() {
  finished_ = true;
  finished_publisher_.publish(boolMessage(true));
  NODELET_INFO("The drive is over: %llu scans", static_cast<unsigned long long>(scans_));
}

void SimulatorNodelet::sendTransforms(const ros::Time& stamp, const RobotPose& pose) {
  const Position origin(config_.odom.x, config_.odom.y);
  const double yaw = config_.odom.yaw;
  const RobotPose in_odom{Eigen::Rotation2Dd(-yaw) * (pose.position - origin), pose.yaw_rad - yaw};
  broadcaster_->sendTransform(std::vector<geometry_msgs::TransformStamped>{
      transformMessage(stamp, config_.map_frame, config_.odom_frame, {origin, yaw}),
      transformMessage(stamp, config_.odom_frame, config_.base_frame, in_odom)});
}

void SimulatorNodelet::sendScan(const ros::Time& stamp, const RobotPose& pose) {
  structure_from_wifi::WifiScan scan;
  scan.header.stamp = stamp;
  scan.header.frame_id = config_.base_frame;
  for (std::size_t i = 0; i < radio_->transmitters().size(); ++i) {
    const std::optional<double> rssi_dbm = radio_->rssi(i, pose, scans_);
    if (rssi_dbm) {
      const Transmitter& transmitter = radio_->transmitters()[i];
      structure_from_wifi::ApReading reading;
      reading.bssid = transmitter.access_point.bssid.str();
      reading.ssid = transmitter.access_point.name;
      reading.rssi_dbm = static_cast<float>(*rssi_dbm);
      reading.frequency_mhz = static_cast<float>(frequencyMhz(transmitter.band));
      scan.readings.push_back(reading);
    }
  }
  scan_publisher_.publish(scan);
  ++scans_;
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
