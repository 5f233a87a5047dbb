#include "ros/simulator/simulator_config.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cctype>
#include <fstream>
#include <string>

#include "simulation/radio/noise_level.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// A plan, a route and an access point.
YAML::Node complete() {
  return YAML::Load(
      "{plan: p.yaml, route: r.csv, access_points: [{bssid: '02:00:00:00:00:01', x: 1, y: 2}]}");
}

/// The shipped file with the settings that it leaves to the noise level.
YAML::Node shippedWithoutCommentSigns() {
  std::ifstream stream(SFW_SOURCE_DIR "/config/simulator.yaml");
  std::string text;
  for (std::string line; std::getline(stream, line);) {
    const bool in_group = line.rfind("#   ", 0) == 0 && std::islower(line[4]) != 0;
    const bool is_setting =
        in_group || line.rfind("# registration_", 0) == 0 || line.rfind("# radio:", 0) == 0;
    text += (is_setting ? line.substr(2) : line) + "\n";
  }
  return YAML::Load(text);
}

std::string problemsOf(const YAML::Node& tree) {
  try {
    simulatorConfigFromYaml(tree);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(SimulatorConfig, ShippedFileNamesEverySettingWithItsDefault) {
  const YAML::Node file = shippedWithoutCommentSigns();
  EXPECT_EQ(unknownSimulatorSettings(file), std::vector<std::string>());
  SimulatorConfig defaults;
  forEachSimulatorSetting(defaults, [&](const std::string& name, const auto& value) {
    const std::size_t slash = name.find('/');
    const YAML::Node node = slash == std::string::npos
                                ? file[name]
                                : file[name.substr(0, slash)][name.substr(slash + 1)];
    ASSERT_TRUE(node) << name << " is missing";
    EXPECT_EQ(node.as<std::decay_t<decltype(value)>>(), value) << name;
  });
}

TEST(SimulatorConfig, ShippedFileLeavesTheRadioToTheNoiseLevel) {
  YAML::Node file = YAML::LoadFile(SFW_SOURCE_DIR "/config/simulator.yaml");
  file["plan"] = "p.json";
  file["noise"] = "hard";
  file["seed"] = 5;
  const RecordingConfig hard = recordingConfig(noiseLevel("hard"), 5);
  const SimulatorConfig config = simulatorConfigFromYaml(file);
  EXPECT_EQ(config.signals.radio.shadowing_db, 5.0);
  EXPECT_EQ(config.signals.radio.exponent, hard.radio.exponent);
  EXPECT_EQ(config.signals.registration_error_m, hard.registration_error_m);
  EXPECT_GT(config.signals.registration_error_m, 0.0);
}

TEST(SimulatorConfig, WhatIsGivenWinsOverTheNoiseLevel) {
  YAML::Node tree = complete();
  tree["noise"] = "none";
  tree["radio"]["shadowing"] = 4.0;
  const SimulatorConfig config = simulatorConfigFromYaml(tree);
  EXPECT_EQ(config.signals.radio.shadowing_db, 4.0);
  EXPECT_EQ(config.signals.radio.sample_noise_db, 0.0);
}

TEST(SimulatorConfig, ReadsGroupsOverDefaults) {
  YAML::Node tree = complete();
  tree["radio"]["exponent"] = 2.5;
  tree["seed"] = 42;
  tree["odom"]["yaw"] = 1;
  const SimulatorConfig config = simulatorConfigFromYaml(tree);
  EXPECT_EQ(config.building.plan, "p.yaml");
  EXPECT_EQ(config.signals.radio.exponent, 2.5);
  EXPECT_EQ(config.signals.radio.seed, 42);
  EXPECT_EQ(config.odom.yaw_rad, 1.0);
  EXPECT_EQ(config.robot.max_speed_m_s, SimulatorConfig().robot.max_speed_m_s);
  ASSERT_EQ(config.access_points.size(), 1U);
  EXPECT_EQ(config.access_points[0].position, Position(1, 2));
}

TEST(SimulatorConfig, NamesEveryProblemAtOnce) {
  YAML::Node tree = complete();
  tree["generate"] = "castle";
  tree["route"] = "";
  tree["drive"] = "joystick";
  tree["speed"] = "fast";
  tree["robot_radius"] = 0;
  tree["tf_rate"] = 0;
  tree["time_scale"] = 6;
  tree["base_frame"] = "/base_link";
  tree["noise"] = "loud";
  tree["drift"] = 2;
  tree["radio"]["interior_wall_loss"] = -1;
  tree["access_points"][0]["x"] = "left";
  EXPECT_EQ(problemsOf(tree),
            "noise: 'loud' is no noise level; the levels are none, low, moderate, realistic, hard\n"
            "speed must be a number; it is 'fast'\n"
            "access_points[0]: 'x' must be a number from -1e8 to 1e8; it is 'left'\n"
            "plan and generate exclude each other: leave one of them empty\n"
            "generate must be flat or office; it is 'castle'\n"
            "route must be walls, sparse or a CSV file with the columns x, y\n"
            "drive must be route or cmd_vel; it is 'joystick'\n"
            "robot_radius must lie in 0.01..10; it is 0\n"
            "tf_rate must lie in 1..1000; it is 0\n"
            "scan_rate must not exceed tf_rate: each scan is stamped with a transform's time\n"
            "time_scale must be 1 unless publish_clock is true\n"
            "base_frame must be a frame's name without a leading slash; it is '/base_link'\n"
            "drift must lie in 0..1; it is 2\n"
            "radio/interior_wall_loss must lie in 0..100; it is -1");
}

TEST(SimulatorConfig, NeedsNoMoreThanABuilding) {
  EXPECT_EQ(problemsOf(YAML::Node()),
            "plan must name a file (map_server YAML, HouseExpo JSON or PNG), or else generate must "
            "be flat or office");
  EXPECT_EQ(problemsOf(YAML::Load("{plan: p.json}")), "no problem");
  EXPECT_EQ(problemsOf(YAML::Load("{generate: office}")), "no problem");
  EXPECT_EQ(problemsOf(YAML::Load("{plan: p.json, access_points: {}}")),
            "access_points must be a list of {bssid, x, y}");
}

TEST(SimulatorConfig, RefusesNotANumber) {
  YAML::Node tree = complete();
  tree["speed"] = ".nan";
  tree["seed"] = 1.5;
  EXPECT_EQ(problemsOf(tree),
            "speed must be a number; it is '.nan'\nseed must be a whole number; it is '1.5'");
}

TEST(SimulatorConfig, FindsMisspeltSettings) {
  YAML::Node tree = complete();
  tree["radio"]["exponnet"] = 2;
  EXPECT_EQ(unknownSimulatorSettings(tree), std::vector<std::string>{"radio/exponnet"});
  EXPECT_TRUE(unknownSimulatorSettings(YAML::Node()).empty());
}

}  // namespace
}  // namespace sfw
