#include "../../src/ros/simulator_config.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// The least that a simulation needs.
YAML::Node complete() {
  return YAML::Load(
      "{plan: p.yaml, route: r.csv, access_points: [{bssid: '02:00:00:00:00:01', x: 1, y: 2}]}");
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
  const YAML::Node file = YAML::LoadFile(SFW_SOURCE_DIR "/config/simulator.yaml");
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

TEST(SimulatorConfig, ReadsGroupsOverDefaults) {
  YAML::Node tree = complete();
  tree["radio"]["exponent"] = 2.5;
  tree["seed"] = 42;
  tree["odom"]["yaw"] = 1;
  const SimulatorConfig config = simulatorConfigFromYaml(tree);
  EXPECT_EQ(config.plan, "p.yaml");
  EXPECT_EQ(config.radio.exponent, 2.5);
  EXPECT_EQ(config.radio.seed, 42);
  EXPECT_EQ(config.odom.yaw, 1.0);
  EXPECT_EQ(config.speed, SimulatorConfig().speed);
  ASSERT_EQ(config.access_points.size(), 1U);
  EXPECT_EQ(config.access_points[0].position, Position(1, 2));
}

TEST(SimulatorConfig, NamesEveryProblemAtOnce) {
  YAML::Node tree = complete();
  tree["route"] = "";
  tree["speed"] = "fast";
  tree["tf_rate"] = 0;
  tree["time_scale"] = 6;
  tree["base_frame"] = "/base_link";
  tree["radio"]["interior_wall_loss"] = -1;
  tree["access_points"][0]["x"] = "left";
  EXPECT_EQ(problemsOf(tree),
            "speed must be a number\n"
            "access_points[0]: 'x' must be a finite number\n"
            "route must name a CSV file with the columns x, y\n"
            "base_frame must be a frame's name without a leading slash\n"
            "tf_rate must lie in 1..1000\n"
            "scan_rate must not exceed tf_rate: each scan is stamped with a transform's time\n"
            "time_scale must be 1 unless publish_clock is true\n"
            "radio/interior_wall_loss must lie in 0..100");
}

TEST(SimulatorConfig, NeedsPlanRouteAndAccessPoints) {
  EXPECT_EQ(problemsOf(YAML::Node()),
            "access_points must be a list with at least one {bssid, x, y}\n"
            "plan must name a map_server YAML file\n"
            "route must name a CSV file with the columns x, y");
}

TEST(SimulatorConfig, RefusesNotANumber) {
  YAML::Node tree = complete();
  tree["speed"] = ".nan";
  tree["seed"] = 1.5;
  EXPECT_EQ(problemsOf(tree), "seed must be a whole number\nspeed must lie in 0.01..10");
}

TEST(SimulatorConfig, FindsMisspeltSettings) {
  YAML::Node tree = complete();
  tree["radio"]["exponnet"] = 2;
  EXPECT_EQ(unknownSimulatorSettings(tree), std::vector<std::string>{"radio/exponnet"});
  EXPECT_TRUE(unknownSimulatorSettings(YAML::Node()).empty());
}

}  // namespace
}  // namespace sfw
