#include "ros/exploration/exploration_settings.h"

#include "files/settings_tree.h"

namespace sfw {

ExplorationSettings explorationSettingsFromYaml(const YAML::Node& node) {
  SettingsTree tree(node);
  ExplorationSettings settings;
  tree.read("driver", settings.driver);
  tree.read("autostart", settings.autostart);
  tree.read("map_frame", settings.map_frame);
  tree.read("base_frame", settings.base_frame);
  tree.read("robot_radius", settings.robot.robot_radius_m);
  tree.read("speed", settings.robot.speed_m_s);
  tree.read("yaw_rate", settings.robot.yaw_rate_rad_s);
  tree.read("touch_time", settings.robot.touch_s);
  tree.read("view", settings.robot.view_m);
  tree.read("least_gain", settings.robot.least_gain_m2);
  tree.read("time_budget", settings.limits.time_s);
  tree.read("way_budget", settings.limits.way_m);
  tree.read("return_home", settings.limits.return_home);
  Problems& problems = tree.problems();
  problems.oneOf("driver", settings.driver, {"bumpers", "move_base"});
  problems.frame("map_frame", settings.map_frame);
  problems.frame("base_frame", settings.base_frame);
  problems.add(validate(settings.robot));
  problems.notNegative("time_budget", settings.limits.time_s);
  problems.notNegative("way_budget", settings.limits.way_m);
  problems.throwIfAny();
  settings.warnings = tree.warnings();
  return settings;
}

}  // namespace sfw
