#include "ros/simulator/simulator_config.h"

#include "base/validation.h"
#include "files/settings_tree.h"
#include "ros/conversion/access_point_parameters.h"
#include "simulation/radio/noise_level.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

void checkBuilding(const SimulatorConfig& config, Problems& problems) {
  const BuildingSource& building = config.building;
  if (!building.plan.empty() && !building.generate.empty()) {
    problems.add("plan and generate exclude each other: leave one of them empty");
  }
  if (building.plan.empty() && building.generate.empty()) {
    problems.add(
        "plan must name a file (map_server YAML, HouseExpo JSON or PNG), or else generate must be "
        "flat or office");
  }
  if (!building.generate.empty()) {
    problems.oneOf("generate", building.generate, {"flat", "office"});
  }
  problems.within("resolution", building.options.resolution_m, 0.01, 0.1);
  problems.within("metres_per_pixel", building.options.metres_per_pixel, 0.0, 10.0);
  problems.within("area", building.area_m2, 30.0, 400.0);
  problems.within("access_point_count", static_cast<double>(config.access_point_count), 1.0, 100.0);
}

void checkDrive(const SimulatorConfig& config, Problems& problems) {
  if (config.route.empty()) {
    problems.add("route must be walls, sparse or a CSV file with the columns x, y");
  }
  problems.oneOf("drive", config.drive, {"route", "cmd_vel"});
  problems.oneOf("bumper", config.bumper, {"contact", "contact_points"});
  const SimulatedRobot::Config& robot = config.robot;
  problems.within("speed", robot.max_speed_m_s, 0.01, 10.0);
  problems.within("yaw_rate", robot.max_yaw_rate_rad_s, 0.01, 100.0);
  problems.within("robot_radius", robot.radius_m, 0.01, 10.0);
  problems.within("acceleration", robot.acceleration_m_s2, 0.01, 1000.0);
  problems.within("yaw_acceleration", robot.yaw_acceleration_rad_s2, 0.01, 10000.0);
  problems.within("command_timeout", robot.command_timeout_s, 0.0, 3600.0);
}

void checkLaser(const SimulatorConfig& config, Problems& problems) {
  problems.within("laser/rate", config.laser.rate_hz, 0.0, 1000.0);
  problems.within("laser/beams", static_cast<double>(config.laser.beams), 1.0, 10000.0);
  problems.within("laser/range", config.laser.range_m, 0.1, 100.0);
  if (config.laser.rate_hz > config.tf_rate_hz) {
    problems.add(
        "laser/rate must not exceed tf_rate: each scan is stamped with a transform's time");
  }
}

void checkTime(const SimulatorConfig& config, Problems& problems) {
  problems.within("tf_rate", config.tf_rate_hz, 1.0, 1000.0);
  problems.within("scan_rate", config.scan_rate_hz, 0.01, 1000.0);
  if (config.scan_rate_hz > config.tf_rate_hz) {
    problems.add("scan_rate must not exceed tf_rate: each scan is stamped with a transform's time");
  }
  problems.within("time_scale", config.time_scale, 0.01, 100.0);
  if (config.time_scale != 1.0 && !config.publish_clock) {
    problems.add("time_scale must be 1 unless publish_clock is true");
  }
  problems.within("start_delay", config.start_delay_s, 0.0, 3600.0);
}

void checkFrames(const SimulatorConfig& config, Problems& problems) {
  constexpr double kFar = 1e6;  // metres; no building reaches farther
  constexpr double kTurn = 10.0;
  problems.frame("map_frame", config.map_frame);
  problems.frame("odom_frame", config.odom_frame);
  problems.frame("base_frame", config.base_frame);
  if (config.map_frame == config.odom_frame || config.odom_frame == config.base_frame ||
      config.map_frame == config.base_frame) {
    problems.add("map_frame, odom_frame and base_frame must differ");
  }
  problems.within("odom/x", config.odom.x_m, -kFar, kFar);
  problems.within("odom/y", config.odom.y_m, -kFar, kFar);
  problems.within("odom/yaw", config.odom.yaw_rad, -kTurn, kTurn);
}

void readSettings(SettingsTree& tree, SimulatorConfig& config) {
  forEachSimulatorSetting(config, [&](const char* name, auto& value) { tree.read(name, value); });
}

/// A configuration with the settings of the noise level that a tree of parameters names.
SimulatorConfig withNoiseLevel(SettingsTree tree, Problems& problems) {
  SimulatorConfig named;
  readSettings(tree, named);
  SimulatorConfig config;
  if (!named.noise.empty()) {
    try {
      config.signals = recordingConfig(noiseLevel(named.noise), named.signals.radio.seed);
    } catch (const InputError& error) {
      problems.add(std::string("noise: ") + error.what());
    }
  }
  return config;
}

}  // namespace

SimulatorConfig simulatorConfigFromYaml(const YAML::Node& node) {
  SettingsTree tree(node);
  Problems& problems = tree.problems();
  SimulatorConfig config = withNoiseLevel(tree, problems);
  readSettings(tree, config);
  if (node.IsMap() && (node["access_points"] || node["access_points_file"])) {
    try {
      config.access_points = accessPointsOfParameters(node).access_points;
      for (const AccessPoint& access_point : config.access_points) {
        if (!access_point.position_known) {
          throw InputError("access_points: " + access_point.bssid.str() +
                           " needs x and y: a simulation does not estimate them");
        }
      }
    } catch (const InputError& error) {
      problems.add(error.what());
    }
  }
  checkBuilding(config, problems);
  checkDrive(config, problems);
  checkLaser(config, problems);
  checkTime(config, problems);
  checkFrames(config, problems);
  problems.add(validate(config.signals));
  problems.throwIfAny();
  return config;
}

std::vector<std::string> unknownSimulatorSettings(const YAML::Node& node) {
  SettingsTree tree(node);
  SimulatorConfig ignored;
  readSettings(tree, ignored);
  return tree.unknown();
}

}  // namespace sfw
