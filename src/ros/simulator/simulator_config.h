#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/building/building_source.h"
#include "simulation/robot/laser.h"
#include "simulation/robot/simulated_robot.h"
#include "simulation/simulated_recording.h"

namespace YAML {
class Node;
}

namespace sfw {

/// Every setting of the simulated robot, with its default. config/simulator.yaml explains each one.
struct SimulatorConfig {
  BuildingSource building;  ///< generated from the seed of `signals`

  std::string route = "walls";  ///< "walls", "sparse" or a CSV file of way points
  std::vector<AccessPoint> access_points;
  std::int64_t access_point_count = 2;  ///< number to choose if none is given

  std::string drive = "route";  ///< or "cmd_vel"
  /// Its speed and yaw rate are those of a route, and the limits of commands.
  SimulatedRobot::Config robot;

  std::string bumper = "contact";  ///< topic of touches: or "contact_points"

  LaserConfig laser;

  double scan_rate_hz = 5.0;    ///< [Hz], simulated time
  double tf_rate_hz = 20.0;     ///< [Hz], simulated time
  bool publish_clock = false;   ///< on /clock; otherwise stamps are the machine's time
  double time_scale = 1.0;      ///< simulated seconds in a real second
  double start_delay_s = 10.0;  ///< the longest wait for a subscriber to the scans [s], real time

  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";

  /// The pose of the odometry's frame in the map frame at the start.
  struct Odom {
    double x_m = 0.0;      ///< [m]
    double y_m = 0.0;      ///< [m]
    double yaw_rad = 0.0;  ///< [rad]
  } odom;

  std::string noise;  ///< name of a NoiseLevel; empty: the defaults below
  /// Radio, errors of the position and the seed of all random numbers. Its speed is not used.
  RecordingConfig signals;
};

/// Calls `visit(name, member)` for each setting but the access points, in the order of
/// config/simulator.yaml; the name is the path of the ROS parameter.
template <class AnyConfig, class Visitor>
void forEachSimulatorSetting(AnyConfig& config, Visitor&& visit) {
  visit("plan", config.building.plan);
  visit("resolution", config.building.options.resolution_m);
  visit("metres_per_pixel", config.building.options.metres_per_pixel);
  visit("generate", config.building.generate);
  visit("area", config.building.area_m2);
  visit("route", config.route);
  visit("access_point_count", config.access_point_count);
  visit("drive", config.drive);
  visit("speed", config.robot.max_speed_m_s);
  visit("yaw_rate", config.robot.max_yaw_rate_rad_s);
  visit("robot_radius", config.robot.radius_m);
  visit("acceleration", config.robot.acceleration_m_s2);
  visit("yaw_acceleration", config.robot.yaw_acceleration_rad_s2);
  visit("command_timeout", config.robot.command_timeout_s);
  visit("bumper", config.bumper);
  visit("laser/rate", config.laser.rate_hz);
  visit("laser/beams", config.laser.beams);
  visit("laser/range", config.laser.range_m);
  visit("scan_rate", config.scan_rate_hz);
  visit("tf_rate", config.tf_rate_hz);
  visit("publish_clock", config.publish_clock);
  visit("time_scale", config.time_scale);
  visit("start_delay", config.start_delay_s);
  visit("map_frame", config.map_frame);
  visit("odom_frame", config.odom_frame);
  visit("base_frame", config.base_frame);
  visit("odom/x", config.odom.x_m);
  visit("odom/y", config.odom.y_m);
  visit("odom/yaw", config.odom.yaw_rad);
  visit("drift", config.signals.drift);
  visit("seed", config.signals.radio.seed);
  visit("noise", config.noise);
  visit("registration_error", config.signals.registration_error_m);
  visit("registration_distance", config.signals.registration_distance_m);
  visit("radio/rssi_at_1m", config.signals.radio.rssi_at_1m_dbm);
  visit("radio/exponent", config.signals.radio.exponent);
  visit("radio/interior_wall_loss", config.signals.radio.interior_wall_loss_db);
  visit("radio/interior_wall_variation", config.signals.radio.interior_wall_variation_db);
  visit("radio/outer_wall_loss", config.signals.radio.outer_wall_loss_db);
  visit("radio/outer_wall_variation", config.signals.radio.outer_wall_variation_db);
  visit("radio/saturation", config.signals.radio.max_obstacle_loss_db);
  visit("radio/shadowing", config.signals.radio.shadowing_db);
  visit("radio/shadowing_distance", config.signals.radio.shadowing_distance_m);
  visit("radio/sample_noise", config.signals.radio.sample_noise_db);
  visit("radio/access_point_pattern", config.signals.radio.access_point_pattern_db);
  visit("radio/robot_pattern", config.signals.radio.robot_pattern_db);
  visit("radio/furniture", config.signals.radio.max_furniture_loss_db);
  visit("radio/step", config.signals.radio.rssi_step_db);
  visit("radio/antenna_height", config.signals.radio.antenna_height_m);
  visit("radio/sensitivity", config.signals.radio.sensitivity_dbm);
  visit("radio/missed", config.signals.radio.missed_share);
}

/// Reads settings and the table `access_points` from a tree of parameters. A setting that is absent
/// has the value of the noise level, or else the default.
/// @throw InputError naming every setting that is missing, of the wrong type or out of range.
SimulatorConfig simulatorConfigFromYaml(const YAML::Node& node);

/// The paths in a tree of parameters that are no settings, probably misspelt.
std::vector<std::string> unknownSimulatorSettings(const YAML::Node& node);

}  // namespace sfw
