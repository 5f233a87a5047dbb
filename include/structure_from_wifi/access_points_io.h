#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/export.h"
#include "structure_from_wifi/types.h"

namespace YAML {
class Node;
}

namespace sfw {

/// A table of access points, with warnings for its author.
struct AccessPointReading {
  std::vector<AccessPoint> access_points;  ///< in the order of the table
  std::vector<std::string> warnings;       ///< unknown keys
};

/// Reads `[{bssid, x?, y?, position_sd?, z?, name?, tx_dbm?}]`.
/// @throw InputError if the table is missing, or naming every unusable or repeated entry.
SFW_EXPORT AccessPointReading accessPointsFromYaml(const YAML::Node& table);

/// Reads a table as accessPointsFromYaml does, from the key `access_points` of a file.
/// @throw InputError naming the file, also if it cannot be read or parsed.
SFW_EXPORT AccessPointReading readAccessPoints(const std::string& file);

/// Formats a table. readAccessPoints reads the text back to the same access points.
SFW_EXPORT std::string accessPointsYaml(const std::vector<AccessPoint>& access_points);

}  // namespace sfw
