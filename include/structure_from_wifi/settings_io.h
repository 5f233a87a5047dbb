#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/types.h"

namespace YAML {
class Node;
}

namespace sfw {

/// A configuration and what its author should hear although it can be used.
struct ConfigReading {
  Config config;                      ///< valid, with defaults where the file names no value
  std::vector<std::string> warnings;  ///< unknown keys, each with the nearest known one
};

/// Reads settings over the defaults: nested maps whose paths are the names of forEachSetting.
/// The key `access_points` is left to readAccessPoints.
/// @throw InputError naming every setting of the wrong type and every problem of validate().
SFW_EXPORT ConfigReading configFromYaml(const YAML::Node& node);

/// As configFromYaml, from a file.
/// @throw InputError naming the file, also if it cannot be read or parsed.
SFW_EXPORT ConfigReading readConfig(const std::string& file);

/// Access points and what the author of their table should hear although it can be used.
struct AccessPointReading {
  std::vector<AccessPoint> access_points;  ///< in the order of the table
  std::vector<std::string> warnings;       ///< keys that nobody reads
};

/// Reads `[{bssid, x?, y?, z?, name?, tx_dbm?}]`.
/// @throw InputError if the table is missing or empty, or naming every unusable or double entry.
SFW_EXPORT AccessPointReading accessPointsFromYaml(const YAML::Node& table);

/// As accessPointsFromYaml, from a file whose key `access_points` holds the table.
/// @throw InputError naming the file, also if it cannot be read or parsed.
SFW_EXPORT AccessPointReading readAccessPoints(const std::string& file);

}  // namespace sfw
