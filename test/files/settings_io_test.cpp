#include "structure_from_wifi/settings_io.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/config.h"
#include "support/complaint.h"

namespace sfw {
namespace {

using test::complaintOf;

const std::filesystem::path kConfigs = std::filesystem::path(SFW_SOURCE_DIR) / "config";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
}

// ---- Shipped files ----

/// Names and values of all settings, as text.
std::vector<std::string> described(const Config& config) {
  std::vector<std::string> settings;
  forEachSetting(config, [&](const std::string& name, const auto& value) {
    settings.push_back(name + " = " + YAML::Dump(YAML::Node(value)));
  });
  return settings;
}

void collectNames(const YAML::Node& node, const std::string& path, std::set<std::string>& names) {
  if (!node.IsMap()) {
    names.insert(path);
    return;
  }
  for (const auto& entry : node) {
    const std::string key = entry.first.as<std::string>();
    collectNames(entry.second, path.empty() ? key : path + "/" + key, names);
  }
}

TEST(ShippedConfig, HoldsEverySettingWithItsDefault) {
  const std::string file = (kConfigs / "mapping.yaml").string();
  const ConfigReading reading = readConfig(file);
  EXPECT_EQ(reading.warnings, std::vector<std::string>());
  EXPECT_EQ(described(reading.config), described(Config()));
  std::set<std::string> known;
  forEachSetting(reading.config, [&](const char* name, const auto&) { known.insert(name); });
  std::set<std::string> written;
  YAML::Node settings = YAML::LoadFile(file);
  settings.remove("ros");          // RosSettings
  settings.remove("scan_format");  // ScanSettings
  collectNames(settings, "", written);
  EXPECT_EQ(written, known);
}

TEST(ShippedConfig, LoadsWhateverItIs) {
  std::size_t tables = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kConfigs)) {
    if (entry.path().extension() != ".yaml") {
      continue;
    }
    const std::string file = entry.path().string();
    const YAML::Node yaml = YAML::LoadFile(file);
    if (yaml["access_points"] && !yaml["levels"]) {  // a suite of `sfw bench` has a number there
      EXPECT_FALSE(readAccessPoints(file).access_points.empty()) << file;
      ++tables;
    }
    if (yaml["map"] || yaml["path"] || yaml["k_visibility"] || yaml["tomography"] ||
        yaml["belief"]) {
      EXPECT_EQ(readConfig(file).warnings, std::vector<std::string>()) << file;
    }
  }
  EXPECT_GE(tables, 1U);
}

// ---- Settings from YAML ----

ConfigReading fromText(const std::string& text) { return configFromYaml(YAML::Load(text)); }

constexpr char kOldNames[] =
    "rssi: {filter: mean, window: 7, path_loss_exponent: 0.9, walls: 3, max_walls: 6,\n"
    "  min_wall_loss: 4.5}\n"
    "tomography: {bin: 0.3, saturation: 20, sparsity: 0.05, straightness: 6, unexplained: 1.5,\n"
    "  directions: 4, members: 5}\n"
    "inference: {footprint_radius: 0.2, max_gap: 1.5, wall_thickness: 0.2, wall_density: 0.03}\n";
constexpr char kNewNames[] =
    "k_visibility: {filter: mean, window: 7, path_loss_exponent: 0.9, wall_count: 3,\n"
    "  max_wall_count: 6, min_wall_loss: 4.5, wall_thickness: 0.2, wall_prior: 0.03}\n"
    "tomography: {bin_size: 0.3, max_total_wall_loss: 20, l1_weight: 0.05, smoothness_weight: 6,\n"
    "  nugget: 1.5, wall_directions: 4, ensemble_size: 5}\n"
    "path: {footprint_radius: 0.2, max_gap: 1.5}\n";

TEST(ConfigFromYaml, TakesEveryOldNameWithAWarning) {
  const ConfigReading of_old = fromText(kOldNames);
  const ConfigReading of_new = fromText(kNewNames);
  EXPECT_EQ(described(of_old.config), described(of_new.config));
  EXPECT_EQ(of_old.warnings.size(), 17U);
  EXPECT_EQ(of_new.warnings, std::vector<std::string>());
  EXPECT_TRUE(
      std::any_of(of_old.warnings.begin(), of_old.warnings.end(), [](const std::string& warning) {
        return contains(warning, "rssi/walls is now called k_visibility/wall_count");
      }));
}

TEST(ConfigFromYaml, PrefersANewNameUnlessItHasItsDefault) {
  const ConfigReading changed = fromText("tomography: {bin: 0.3, bin_size: 0.4}");
  EXPECT_EQ(described(changed.config), described(fromText("tomography: {bin_size: 0.4}").config));
  ASSERT_EQ(changed.warnings.size(), 1U);
  EXPECT_TRUE(contains(changed.warnings[0], "tomography/bin is ignored"));
  const ConfigReading shipped = fromText("tomography: {bin: 0.3, bin_size: 0.2}");
  EXPECT_EQ(described(shipped.config), described(fromText("tomography: {bin_size: 0.3}").config));
  EXPECT_EQ(shipped.warnings.size(), 1U);
}

TEST(ConfigReader, ReadsOverTheDefaults) {
  const Config config = fromText("map: {resolution: 0.1, max_cells: 1e6}").config;
  EXPECT_EQ(config.map.resolution_m, 0.1);
  EXPECT_EQ(config.map.max_cells, 1000000);
  EXPECT_EQ(config.map.margin_m, Config().map.margin_m);
}

TEST(ConfigReader, TakesAnEmptyTextForTheDefaults) {
  for (const std::string text : {"", "# nothing", "{}"}) {
    EXPECT_EQ(described(fromText(text).config), described(Config())) << text;
  }
}

TEST(ConfigReader, LeavesAccessPointsToTheirReader) {
  EXPECT_TRUE(fromText("access_points: [{bssid: nonsense}]").warnings.empty());
}

TEST(ConfigReader, LeavesTheGroupOfRosToTheNodelet) {
  EXPECT_TRUE(fromText("ros: {map_frame: odom, misspelt: 1}").warnings.empty());
  EXPECT_TRUE(fromText("ros: 3").warnings.empty());
  EXPECT_EQ(fromText("rosa: {x: 1}").warnings.size(), 1U);
}

TEST(ConfigReader, NamesTheNearestSettingOfAnUnknownKey) {
  const auto warnings = fromText("map: {resolutoin: 0.1}\nwindow: 3").warnings;
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0], "map/resolutoin is not a setting; did you mean map/resolution?");
  EXPECT_TRUE(contains(warnings[1], "window is not a setting; did you mean k_visibility/window"));
  EXPECT_EQ(fromText("mapping: {belief: {free_threshold: 0.3}}").warnings,
            std::vector<std::string>{
                "mapping/belief is not read: the group belief must stand at the top"});
}

TEST(ConfigReader, NamesEveryWrongTypeAndEveryBrokenRuleAtOnce) {
  const std::string complaint = complaintOf([] {
    fromText(
        "map: {resolution: fine, max_cells: 2.5, margin: -1}\n"
        "k_visibility: {filter: [median], window: .nan}");
  });
  EXPECT_TRUE(contains(complaint, "map/resolution must be a number; it is 'fine'"));
  EXPECT_TRUE(contains(complaint, "map/max_cells must be a whole number; it is '2.5'"));
  EXPECT_TRUE(contains(complaint, "map/margin must be finite and positive; it is -1"));
  EXPECT_TRUE(contains(complaint, "k_visibility/filter must be a text; it is a list"));
  EXPECT_TRUE(contains(complaint, "k_visibility/window must be a whole number"));
  EXPECT_EQ(lines(complaint), 5U) << complaint;
}

TEST(ConfigFromYaml, NamesAnOldNameWhoseValueHasTheWrongType) {
  EXPECT_EQ(complaintOf([] { fromText("rssi: {window: wide}"); }),
            "rssi/window must be a whole number; it is 'wide'");
}

TEST(ConfigReader, RefusesAGroupInPlaceOfAValueAndTheReverse) {
  EXPECT_TRUE(contains(complaintOf([] { fromText("[1, 2]"); }), "settings must be groups"));
  EXPECT_TRUE(contains(complaintOf([] { fromText("just a text"); }), "settings must be groups"));
  EXPECT_EQ(fromText("map: 3").warnings,
            std::vector<std::string>{"map is a group of settings and has no value"});
  EXPECT_TRUE(contains(complaintOf([] { fromText("map: {resolution: {metres: 0.1}}"); }),
                       "map/resolution must be a number; it is a group"));
}

TEST(ConfigReader, RefusesKeysThatAreNoText) {
  EXPECT_NE(complaintOf([] { fromText("map: {[1, 2]: 3}"); }), "nothing");
}

TEST(ConfigReader, SurvivesAMapThatHoldsItself) {
  EXPECT_EQ(fromText("map: &loop {loop: *loop}").warnings.size(), 1U);
}

TEST(ConfigReader, NamesTheFileThatCannotBeReadOrParsed) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "config_test";
  std::filesystem::create_directories(folder);
  const std::string broken = (folder / "broken.yaml").string();
  std::ofstream(broken) << "map:\n  resolution: [0.1\n";
  EXPECT_TRUE(contains(complaintOf([&] { readConfig(broken); }), broken + ": line "));
  std::ofstream(broken) << "map: {resolution: 0}\n";
  EXPECT_TRUE(contains(complaintOf([&] { readConfig(broken); }), broken + ": map/resolution"));
  const std::string missing = (folder / "missing.yaml").string();
  EXPECT_TRUE(contains(complaintOf([&] { readConfig(missing); }), missing));
  EXPECT_TRUE(contains(complaintOf([&] { readConfig(folder.string()); }), folder.string()));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sfw
