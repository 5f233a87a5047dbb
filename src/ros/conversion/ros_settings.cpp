#include "ros/conversion/ros_settings.h"

#include "base/validation.h"
#include "files/settings_tree.h"

namespace sfw {

std::vector<std::string> validate(const RosSettings& settings) {
  Problems problems;
  problems.frame("ros/map_frame", settings.map_frame);
  problems.frame("ros/antenna_frame", settings.antenna_frame);
  problems.frame("ros/odom_frame", settings.odom_frame);
  problems.positive("ros/jump_distance", settings.jump_distance_m);
  problems.positive("ros/jump_angle", settings.jump_angle_rad);
  problems.positive("ros/publish_rate", settings.publish_rate_hz);
  problems.notNegative("ros/transform_timeout", settings.transform_timeout_s);
  problems.positive("ros/tf_cache", settings.tf_cache_s);
  problems.atLeast("ros/max_waiting", settings.max_waiting, 1);
  problems.require(!settings.save_directory.empty(), "ros/save_directory",
                   "'" + settings.save_directory + "'", "a directory");
  problems.notNegative("ros/autosave_period", settings.autosave_period_s);
  return problems.list();
}

MappingSettings mappingSettingsFromYaml(const YAML::Node& node) {
  MappingSettings settings;
  SettingsTree tree(node);
  tree.dropGroup("clicked_point_bssid");  // read at each click
  readSettings(tree, settings.config);
  forEachRosSetting(settings.ros, [&](const char* name, auto& value) { tree.read(name, value); });
  tree.problems().add(validate(settings.ros));
  tree.problems().throwIfAny();
  settings.warnings = tree.warnings();
  return settings;
}

MappingSettings readMappingSettings(const std::string& file) {
  return readYaml(file, mappingSettingsFromYaml);
}

}  // namespace sfw
