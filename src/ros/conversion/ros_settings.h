#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros/conversion/scan_settings.h"
#include "structure_from_wifi/config.h"

namespace YAML {
class Node;
}

namespace sfw {

/// Settings that only the ROS side of mapping has: the group `ros` in config/mapping.yaml.
struct RosSettings {
  std::string map_frame = "map";            ///< of the map and the access points
  std::string antenna_frame = "base_link";  ///< whose position is that of a reading
  std::string antenna_frames;               ///< of several robots, separated by blanks
  std::string odom_frame;                   ///< readings follow it when the past is corrected
  double jump_distance_m = 0.1;             ///< a larger correction of odom_frame moves the past
  double jump_angle_rad = 0.05;             ///< a larger turn of odom_frame moves it too
  double publish_rate_hz = 1.0;             ///< upper limit of map updates
  double cpu_share = 0.25;                  ///< of one core that map updates may take
  double transform_timeout_s = 5.0;         ///< longest wait of a scan for its transform
  double tf_cache_s = 30.0;                 ///< time for which transforms are stored
  std::int64_t max_waiting = 2000;          ///< scans that may wait for a transform
  bool map_updates = false;                 ///< publish changes on map_updates
  std::string save_directory = "~/.ros/structure_from_wifi";  ///< of ~save_map
  double autosave_period_s = 60.0;                            ///< of saving the session; 0: never
  bool resume = false;                                        ///< go on with the session saved last
  bool resume_after_respawn = false;  ///< go on with this session if the process starts again
  std::string on_time_jump = "keep";  ///< the map when the clock jumps back: or "reset"
  double max_tilt_rad = 0.35;         ///< of the antenna against its first pose, before a warning
  double max_speed_m_s = 0.0;         ///< readings that come faster are dropped; 0: none are
  double localisation_rate_hz = 0.0;  ///< upper limit of ~localisation; 0: none is published
};

/// Calls `visit(name, member)` for each setting, as forEachSetting does for those of the mapper.
template <class AnySettings, class Visitor>
void forEachRosSetting(AnySettings& settings, Visitor&& visit) {
  visit("ros/map_frame", settings.map_frame);
  visit("ros/antenna_frame", settings.antenna_frame);
  visit("ros/antenna_frames", settings.antenna_frames);
  visit("ros/odom_frame", settings.odom_frame);
  visit("ros/jump_distance", settings.jump_distance_m);
  visit("ros/jump_angle", settings.jump_angle_rad);
  visit("ros/publish_rate", settings.publish_rate_hz);
  visit("ros/cpu_share", settings.cpu_share);
  visit("ros/transform_timeout", settings.transform_timeout_s);
  visit("ros/tf_cache", settings.tf_cache_s);
  visit("ros/max_waiting", settings.max_waiting);
  visit("ros/map_updates", settings.map_updates);
  visit("ros/save_directory", settings.save_directory);
  visit("ros/autosave_period", settings.autosave_period_s);
  visit("ros/resume", settings.resume);
  visit("ros/resume_after_respawn", settings.resume_after_respawn);
  visit("ros/on_time_jump", settings.on_time_jump);
  visit("ros/max_tilt", settings.max_tilt_rad);
  visit("ros/max_speed", settings.max_speed_m_s);
  visit("ros/localisation_rate", settings.localisation_rate_hz);
}

/// The name of a frame without leading slashes, which tf's first version had and tf2 refuses.
std::string withoutSlash(const std::string& frame);

/// The antenna's frame of each robot: ros/antenna_frames, or else ros/antenna_frame alone.
std::vector<std::string> antennaFrames(const RosSettings& settings);

/// What is wrong with a frame that has leading slashes, in words; empty if it has none.
std::string slashProblem(const std::string& frame);

/// Every problem of the settings, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const RosSettings& settings);

/// All settings of config/mapping.yaml.
struct MappingSettings {
  Config config;
  RosSettings ros;
  ScanSettings scan;
  std::vector<std::string> warnings;  ///< unknown names, each with the nearest known one
};

/// Reads settings over the defaults. accessPointsOfParameters reads the
/// keys `access_points` and `access_points_file`.
/// @throw InputError naming every setting of the wrong type and every problem of validate().
MappingSettings mappingSettingsFromYaml(const YAML::Node& node);

/// Reads settings as mappingSettingsFromYaml does, from a file.
/// @throw InputError naming the file, also if it cannot be read or parsed.
MappingSettings readMappingSettings(const std::string& file);

}  // namespace sfw
