#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"

namespace YAML {
class Node;
}

namespace sfw {

/// Settings of the mapper, with warnings for their author.
struct ConfigReading {
  Config config;                      ///< valid, with defaults where the file names no value
  std::vector<std::string> warnings;  ///< unknown keys, each with the nearest known one
};

/// Reads settings over the defaults: nested maps whose paths are the names of forEachSetting.
/// readAccessPoints reads the key `access_points`. The nodelet reads the group `ros`.
/// @throw InputError naming every setting of the wrong type and every problem of validate().
SFW_EXPORT ConfigReading configFromYaml(const YAML::Node& node);

/// Reads settings as configFromYaml does, from a file.
/// @throw InputError naming the file, also if it cannot be read or parsed.
SFW_EXPORT ConfigReading readConfig(const std::string& file);

}  // namespace sfw
