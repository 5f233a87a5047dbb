#include "ros/conversion/ros_settings.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <type_traits>

#include "base/validation.h"
#include "files/settings_tree.h"
#include "files/text.h"
#include "ros/conversion/robot_topics.h"

namespace sfw {
namespace {

std::vector<std::string> framesIn(std::string text) {
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

/// Takes the leading slashes of tf's first version from the frames, which tf2 refuses.
void stripSlashes(RosSettings& settings, std::vector<std::string>& warnings) {
  forEachRosSetting(settings, [&](const std::string& name, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
      const bool is_frame = name.size() > 6 && name.compare(name.size() - 6, 6, "_frame") == 0;
      const std::string frame = withoutSlash(value);
      if (is_frame && frame != value) {
        warnings.push_back(name + ": " + slashProblem(value));
        value = frame;
      }
    }
  });
  for (const std::string& frame : framesIn(settings.antenna_frames)) {
    if (const std::string problem = slashProblem(frame); !problem.empty()) {
      warnings.push_back("ros/antenna_frames: " + problem);
    }
  }
}

void checkAntennaFrames(const RosSettings& settings, Problems& problems) {
  const std::vector<std::string> frames = antennaFrames(settings);
  if (frames.size() < 2) {
    problems.frame(settings.antenna_frames.empty() ? "ros/antenna_frame" : "ros/antenna_frames",
                   frames.front());
    return;
  }
  for (const std::string& frame : frames) {
    problems.frame("ros/antenna_frames", frame);
  }
  std::vector<std::string> names = robotNames(frames);
  std::sort(names.begin(), names.end());
  problems.require(std::unique(names.begin(), names.end()) == names.end(), "ros/antenna_frames",
                   "'" + settings.antenna_frames + "'",
                   "frames that differ in letters, digits, '_' and '/'");
  problems.require(settings.odom_frame.empty() || settings.odom_frame == settings.map_frame,
                   "ros/odom_frame", "'" + settings.odom_frame + "'",
                   "empty or ros/map_frame if ros/antenna_frames names several robots");
}

}  // namespace

std::string withoutSlash(const std::string& frame) {
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

std::string slashProblem(const std::string& frame) {
  constexpr std::size_t kLongest = 100;
  if (withoutSlash(frame) == frame) {
    return "";
  }
  const std::string shown = printable(frame, kLongest);
  return "frames of tf2 have no leading slash; '" + shown + "' is taken as '" +
         withoutSlash(shown) + "'";
}

std::vector<std::string> antennaFrames(const RosSettings& settings) {
  std::vector<std::string> frames = framesIn(settings.antenna_frames);
  std::transform(frames.begin(), frames.end(), frames.begin(), withoutSlash);
  return frames.empty() ? std::vector<std::string>{settings.antenna_frame} : frames;
}

std::vector<std::string> validate(const RosSettings& settings) {
  Problems problems;
  problems.frame("ros/map_frame", settings.map_frame);
  checkAntennaFrames(settings, problems);
  if (!settings.odom_frame.empty()) {  // empty: to be found in tf
    problems.frame("ros/odom_frame", settings.odom_frame);
  }
  problems.positive("ros/jump_distance", settings.jump_distance_m);
  problems.positive("ros/jump_angle", settings.jump_angle_rad);
  problems.positive("ros/publish_rate", settings.publish_rate_hz);
  constexpr double kLeastShare = 0.01;  // one update of 0.2 s in 20 s
  problems.within("ros/cpu_share", settings.cpu_share, kLeastShare, 1.0);
  problems.notNegative("ros/transform_timeout", settings.transform_timeout_s);
  problems.positive("ros/tf_cache", settings.tf_cache_s);
  problems.atLeast("ros/max_waiting", settings.max_waiting, 1);
  problems.require(!settings.save_directory.empty(), "ros/save_directory",
                   "'" + settings.save_directory + "'", "a directory");
  problems.notNegative("ros/autosave_period", settings.autosave_period_s);
  problems.oneOf("ros/on_time_jump", settings.on_time_jump, {"keep", "reset"});
  problems.positive("ros/max_tilt", settings.max_tilt_rad);
  problems.notNegative("ros/max_speed", settings.max_speed_m_s);
  constexpr double kFastestHz = 100.0;  // faster than any scanner
  problems.within("ros/localisation_rate", settings.localisation_rate_hz, 0.0, kFastestHz, "Hz");
  return problems.list();
}

MappingSettings mappingSettingsFromYaml(const YAML::Node& node) {
  MappingSettings settings;
  SettingsTree tree(node);
  tree.dropGroup("clicked_point_bssid");  // read at each click
  tree.dropGroup("live");                 // of dynamic_reconfigure
  readSettings(tree, settings.config);
  forEachRosSetting(settings.ros, [&](const char* name, auto& value) { tree.read(name, value); });
  forEachScanSetting(settings.scan, [&](const char* name, auto& value) { tree.read(name, value); });
  std::vector<std::string> slashes;
  stripSlashes(settings.ros, slashes);
  tree.problems().add(validate(settings.ros));
  tree.problems().add(validate(settings.scan));
  tree.problems().throwIfAny();
  settings.warnings = tree.warnings();
  settings.warnings.insert(settings.warnings.end(), slashes.begin(), slashes.end());
  return settings;
}

MappingSettings readMappingSettings(const std::string& file) {
  return readYaml(file, mappingSettingsFromYaml);
}

}  // namespace sfw
