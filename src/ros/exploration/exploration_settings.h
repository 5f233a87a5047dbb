#pragma once

#include <string>
#include <vector>

#include "exploration/explorer.h"
#include "structure_from_wifi/exploration.h"

namespace YAML {
class Node;
}

namespace sfw {

/// The settings of ExplorationNodelet. config/exploration.yaml explains each one.
struct ExplorationSettings {
  std::string driver = "bumpers";  ///< or "move_base"
  bool autostart = true;
  std::string map_frame = "map";
  std::string base_frame = "base_link";
  ExplorationConfig robot;
  Explorer::Limits limits;
  std::vector<std::string> warnings;
};

/// Reads the settings over the defaults.
/// @throw InputError naming every setting that cannot be used
ExplorationSettings explorationSettingsFromYaml(const YAML::Node& node);

}  // namespace sfw
