#pragma once

#include <string>
#include <vector>

#include "wireless/wireless_reader.h"

namespace YAML {
class Node;
}

namespace sfw {

/// The settings of WirelessScanNodelet. config/wireless_scan.yaml explains each one.
struct WirelessSettings {
  std::string mode = "cache";  ///< link, cache or scan
  std::string interface;       ///< of the adapter; empty: the first client of access points
  double rate_hz = 5.0;        ///< looks at the radio; a scan takes longer
  std::string frame_id;        ///< of the antenna, for the scans' header; may be empty
  std::vector<std::string> warnings;
};

/// Reads the settings over the defaults.
/// @throw InputError naming every setting that cannot be used
WirelessSettings wirelessSettingsFromYaml(const YAML::Node& node);

/// The mode with this name; the settings hold no other names.
WirelessMode wirelessMode(const std::string& name);

}  // namespace sfw
