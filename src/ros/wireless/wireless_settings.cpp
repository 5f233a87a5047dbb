#include "ros/wireless/wireless_settings.h"

#include "files/settings_tree.h"

namespace sfw {

WirelessSettings wirelessSettingsFromYaml(const YAML::Node& node) {
  SettingsTree tree(node);
  WirelessSettings settings;
  tree.read("mode", settings.mode);
  tree.read("interface", settings.interface);
  tree.read("rate", settings.rate_hz);
  tree.read("frame_id", settings.frame_id);
  tree.problems().oneOf("mode", settings.mode, {"link", "cache", "scan"});
  tree.problems().within("rate", settings.rate_hz, 0.01, 20.0, "Hz");
  tree.problems().throwIfAny();
  settings.warnings = tree.warnings();
  return settings;
}

WirelessMode wirelessMode(const std::string& name) {
  if (name == "link") {
    return WirelessMode::kLink;
  }
  return name == "scan" ? WirelessMode::kScan : WirelessMode::kCache;
}

}  // namespace sfw
