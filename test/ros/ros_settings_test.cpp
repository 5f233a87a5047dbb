#include "ros/conversion/ros_settings.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <set>

#include "ros/conversion/parameters.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

using Names = std::vector<std::string>;

/// The settings that validate() complains of after one of them was changed.
template <class T>
Names brokenBy(const std::string& name, T value) {
  RosSettings settings;
  forEachRosSetting(settings, [&](const std::string& known, auto& setting) {
    if constexpr (std::is_same_v<std::decay_t<decltype(setting)>, T>) {
      setting = known == name ? value : setting;
    }
  });
  Names names;
  for (const std::string& problem : validate(settings)) {
    names.push_back(problem.substr(0, problem.find(' ')));
  }
  return names;
}

TEST(RosSettings, DefaultsAreValid) { EXPECT_EQ(validate(RosSettings()), Names()); }

TEST(RosSettings, NumbersHaveTheirRanges) {
  for (const std::string name :
       {"ros/jump_distance", "ros/jump_angle", "ros/publish_rate", "ros/tf_cache"}) {
    for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
      EXPECT_EQ(brokenBy(name, bad), Names{name}) << bad;
    }
    EXPECT_EQ(brokenBy(name, 1e-3), Names());
  }
  EXPECT_EQ(brokenBy("ros/transform_timeout", -1e-9), Names{"ros/transform_timeout"});
  EXPECT_EQ(brokenBy("ros/transform_timeout", 0.0), Names());
  EXPECT_EQ(brokenBy("ros/cpu_share", 0.0), Names{"ros/cpu_share"});
  EXPECT_EQ(brokenBy("ros/cpu_share", 1.01), Names{"ros/cpu_share"});
  EXPECT_EQ(brokenBy("ros/cpu_share", 0.01), Names());
  EXPECT_EQ(brokenBy("ros/cpu_share", 1.0), Names());
  EXPECT_EQ(brokenBy("ros/autosave_period", -1e-9), Names{"ros/autosave_period"});
  EXPECT_EQ(brokenBy("ros/autosave_period", 0.0), Names());
  EXPECT_EQ(brokenBy("ros/max_waiting", std::int64_t{0}), Names{"ros/max_waiting"});
  EXPECT_EQ(brokenBy("ros/max_waiting", std::int64_t{1}), Names());
}

TEST(RosSettings, LimitsOfPosesAndTheAnswerToATimeJump) {
  EXPECT_EQ(brokenBy("ros/max_tilt", 0.0), Names{"ros/max_tilt"});
  EXPECT_EQ(brokenBy("ros/max_speed", -1e-9), Names{"ros/max_speed"});
  EXPECT_EQ(brokenBy("ros/max_speed", 0.0), Names());
  EXPECT_EQ(brokenBy("ros/localisation_rate", -1e-9), Names{"ros/localisation_rate"});
  EXPECT_EQ(brokenBy("ros/localisation_rate", 0.0), Names());
  EXPECT_EQ(brokenBy("ros/localisation_rate", 100.0), Names());
  EXPECT_EQ(brokenBy("ros/localisation_rate", 1e9), Names{"ros/localisation_rate"});
  EXPECT_EQ(brokenBy("ros/on_time_jump", std::string("wait")), Names{"ros/on_time_jump"});
  EXPECT_EQ(brokenBy("ros/on_time_jump", std::string("reset")), Names());
}

TEST(MappingSettings, FramesLoseTheirLeadingSlashWithAWarning) {
  const MappingSettings settings =
      mappingSettingsFromYaml(YAML::Load("ros: {map_frame: //map, antenna_frame: robot/wifi}"));
  EXPECT_EQ(settings.ros.map_frame, "map");
  EXPECT_EQ(settings.ros.antenna_frame, "robot/wifi");
  EXPECT_EQ(settings.warnings,
            Names{"ros/map_frame: frames of tf2 have no leading slash; '//map' is taken as 'map'"});
  EXPECT_THROW(mappingSettingsFromYaml(YAML::Load("ros: {map_frame: /}")), InputError);
}

TEST(RosSettings, FramesAndTheDirectoryHaveNames) {
  for (const std::string name : {"ros/map_frame", "ros/antenna_frame"}) {
    EXPECT_EQ(brokenBy(name, std::string()), Names{name});
    EXPECT_EQ(brokenBy(name, std::string("/map")), Names{name});
  }
  EXPECT_EQ(brokenBy("ros/odom_frame", std::string()), Names()) << "it is found in tf";
  EXPECT_EQ(brokenBy("ros/odom_frame", std::string("/odom")), Names{"ros/odom_frame"});
  EXPECT_EQ(brokenBy("ros/save_directory", std::string()), Names{"ros/save_directory"});
}

TEST(RosSettings, SeveralRobotsHaveAFrameEach) {
  RosSettings settings;
  EXPECT_EQ(antennaFrames(settings), Names{"base_link"});
  settings.antenna_frames = " robot1/wifi, /robot2/wifi ";
  EXPECT_EQ(antennaFrames(settings), (Names{"robot1/wifi", "robot2/wifi"}));
  EXPECT_EQ(validate(settings), Names());
  settings.odom_frame = "map";
  EXPECT_EQ(validate(settings), Names()) << "no correction of the past";
  settings.odom_frame = "robot1/odom";
  EXPECT_EQ(validate(settings).size(), 1U);
  EXPECT_EQ(brokenBy("ros/antenna_frames", std::string("robot1/wifi robot1/wifi")),
            Names{"ros/antenna_frames"});
  EXPECT_EQ(brokenBy("ros/antenna_frames", std::string("robot-1/wifi robot_1/wifi")),
            Names{"ros/antenna_frames"})
      << "their topics would be the same";
}

/// Names and values of all settings, as text.
Names described(const MappingSettings& settings) {
  Names described;
  const auto describe = [&](const std::string& name, const auto& value) {
    described.push_back(name + " = " + YAML::Dump(YAML::Node(value)));
  };
  forEachSetting(settings.config, describe);
  forEachRosSetting(settings.ros, describe);
  forEachScanSetting(settings.scan, describe);
  return described;
}

TEST(MappingSettings, TheShippedFileHoldsEverySettingWithItsDefault) {
  const std::string file = std::string(SFW_SOURCE_DIR) + "/config/mapping.yaml";
  const MappingSettings settings = readMappingSettings(file);
  EXPECT_EQ(settings.warnings, Names());
  EXPECT_EQ(described(settings), described(MappingSettings()));
  const YAML::Node tree = YAML::LoadFile(file);
  std::size_t count = 0;
  const auto look = [&](const std::string& name, const auto&) {
    const std::size_t slash = name.find('/');
    EXPECT_TRUE(tree[name.substr(0, slash)][name.substr(slash + 1)]) << name;
    ++count;
  };
  forEachRosSetting(settings.ros, look);
  forEachScanSetting(settings.scan, look);
  EXPECT_EQ(tree["ros"].size() + tree["scan_format"].size(), count);
}

TEST(MappingSettings, ParametersGiveBothGroups) {
  XmlRpc::XmlRpcValue tree;
  tree["map"]["resolution"] = 0.1;
  tree["ros"]["map_frame"] = "floor";
  tree["ros"]["transform_timeout"] = 2;
  const MappingSettings settings = mappingSettingsFromYaml(toYaml(tree));
  EXPECT_EQ(settings.config.map.resolution_m, 0.1);
  EXPECT_EQ(settings.ros.map_frame, "floor");
  EXPECT_EQ(settings.ros.transform_timeout_s, 2.0);
  EXPECT_EQ(settings.warnings, Names());
}

TEST(MappingSettings, ParametersMayHaveTheirOldNames) {
  XmlRpc::XmlRpcValue tree;
  tree["inference"]["max_gap"] = 2.5;
  tree["path"]["max_gap"] = 1.0;  // as shipped: launch files load the shipped file first
  const MappingSettings settings = mappingSettingsFromYaml(toYaml(tree));
  EXPECT_EQ(settings.config.path.max_gap_m, 2.5);
  ASSERT_EQ(settings.warnings.size(), 1U);
  EXPECT_EQ(settings.warnings[0].rfind("inference/max_gap is now called path/max_gap", 0), 0U);
}

TEST(MappingSettings, AnUnknownNameGetsTheNearestOfBothGroups) {
  EXPECT_EQ(mappingSettingsFromYaml(YAML::Load("ros: {map_fram: x}\nantenna_frame: y")).warnings,
            (Names{"antenna_frame is not a setting; did you mean ros/antenna_frame?",
                   "ros/map_fram is not a setting; did you mean ros/map_frame?"}));
}

TEST(MappingSettings, AnErrorNamesTheProblemsOfBothGroups) {
  try {
    mappingSettingsFromYaml(YAML::Load("map: {margin: -1}\nros: {publish_rate: }"));
    FAIL() << "the settings were accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "map/margin must be finite and positive; it is -1\n"
              "ros/publish_rate must be a number; it is empty");
  }
}

}  // namespace
}  // namespace sfw
