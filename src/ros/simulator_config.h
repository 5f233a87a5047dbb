#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/radio_model.h"

namespace YAML {
class Node;
}

namespace sfw {

/// Every setting of the simulated robot, with its default. config/simulator.yaml explains each one.
struct SimulatorConfig {
  std::string plan;   ///< floor plan: a map_server YAML file
  std::string route;  ///< way points: a CSV file

  double speed = 0.5;          ///< [m/s]
  double yaw_rate = 2.0;       ///< of turns on the spot [rad/s]
  double robot_radius = 0.15;  ///< [m]

  double scan_rate = 5.0;      ///< [Hz], simulated time
  double tf_rate = 20.0;       ///< [Hz], simulated time
  bool publish_clock = false;  ///< on /clock; otherwise the drive keeps to the machine's clock
  double time_scale = 1.0;     ///< simulated seconds in a real one
  double start_delay = 10.0;   ///< the longest wait for a subscriber to the scans [s], real time

  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";

  /// Where the odometry's frame lies in the map's.
  struct Odom {
    double x = 0.0;    ///< [m]
    double y = 0.0;    ///< [m]
    double yaw = 0.0;  ///< [rad]
  } odom;

  RadioModel::Config radio;
  std::vector<AccessPoint> access_points;
};

/// Calls `visit(name, member)` for each setting but the access points, in the order of
/// config/simulator.yaml; the name is the path of the ROS parameter.
template <class AnyConfig, class Visitor>
void forEachSimulatorSetting(AnyConfig& config, Visitor&& visit) {
  visit("plan", config.plan);
  visit("route", config.route);
  visit("speed", config.speed);
  visit("yaw_rate", config.yaw_rate);
  visit("robot_radius", config.robot_radius);
  visit("scan_rate", config.scan_rate);
  visit("tf_rate", config.tf_rate);
  visit("publish_clock", config.publish_clock);
  visit("time_scale", config.time_scale);
  visit("start_delay", config.start_delay);
  visit("map_frame", config.map_frame);
  visit("odom_frame", config.odom_frame);
  visit("base_frame", config.base_frame);
  visit("odom/x", config.odom.x);
  visit("odom/y", config.odom.y);
  visit("odom/yaw", config.odom.yaw);
  visit("seed", config.radio.seed);
  visit("radio/rssi_at_1m", config.radio.rssi_at_1m);
  visit("radio/exponent", config.radio.exponent);
  visit("radio/interior_wall_loss", config.radio.interior_wall_loss);
  visit("radio/interior_wall_variation", config.radio.interior_wall_variation);
  visit("radio/outer_wall_loss", config.radio.outer_wall_loss);
  visit("radio/outer_wall_variation", config.radio.outer_wall_variation);
  visit("radio/saturation", config.radio.saturation);
  visit("radio/shadowing", config.radio.shadowing);
  visit("radio/shadowing_distance", config.radio.shadowing_distance);
  visit("radio/sample_noise", config.radio.sample_noise);
  visit("radio/access_point_pattern", config.radio.access_point_pattern);
  visit("radio/robot_pattern", config.radio.robot_pattern);
  visit("radio/furniture", config.radio.furniture);
  visit("radio/step", config.radio.step);
  visit("radio/antenna_height", config.radio.antenna_height);
  visit("radio/sensitivity", config.radio.sensitivity);
  visit("radio/missed", config.radio.missed);
}

/// Reads settings over the defaults, and the table `access_points`.
/// @throw InputError naming every setting that is missing, of the wrong type or out of range.
SimulatorConfig simulatorConfigFromYaml(const YAML::Node& tree);

/// The paths in a tree of parameters that name no setting: probably misspelt.
std::vector<std::string> unknownSimulatorSettings(const YAML::Node& tree);

}  // namespace sfw
