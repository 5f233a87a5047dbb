#include "structure_from_wifi/settings_io.h"

#include <utility>

#include "files/settings_tree.h"

namespace sfw {
namespace {

/// Old names of settings, which this release still reads, and their names now.
constexpr std::pair<const char*, const char*> kRenamed[] = {
    {"inference/footprint_radius", "path/footprint_radius"},
    {"inference/max_gap", "path/max_gap"},
    {"inference/wall_density", "k_visibility/wall_prior"},
    {"inference/wall_thickness", "k_visibility/wall_thickness"},
    {"rssi/filter", "k_visibility/filter"},
    {"rssi/max_walls", "k_visibility/max_wall_count"},
    {"rssi/min_wall_loss", "k_visibility/min_wall_loss"},
    {"rssi/path_loss_exponent", "k_visibility/path_loss_exponent"},
    {"rssi/walls", "k_visibility/wall_count"},
    {"rssi/window", "k_visibility/window"},
    {"tomography/bin", "tomography/bin_size"},
    {"tomography/directions", "tomography/wall_directions"},
    {"tomography/members", "tomography/ensemble_size"},
    {"tomography/saturation", "tomography/max_total_wall_loss"},
    {"tomography/sparsity", "tomography/l1_weight"},
    {"tomography/straightness", "tomography/smoothness_weight"},
    {"tomography/unexplained", "tomography/nugget"},
};

}  // namespace

void readSettings(SettingsTree& tree, Config& config) {
  for (const auto& [old_name, name] : kRenamed) {
    tree.addOldName(old_name, name);
  }
  forEachSetting(config, [&](const char* name, auto& value) { tree.read(name, value); });
  tree.problems().add(validate(config));
}

ConfigReading configFromYaml(const YAML::Node& node) {
  SettingsTree tree(node);
  tree.dropGroup("ros");  // of the nodelet, which reads the same file; so is the next one
  tree.dropGroup("scan_format");
  ConfigReading reading;
  readSettings(tree, reading.config);
  tree.problems().throwIfAny();
  reading.warnings = tree.warnings();
  return reading;
}

ConfigReading readConfig(const std::string& file) { return readYaml(file, configFromYaml); }

}  // namespace sfw
