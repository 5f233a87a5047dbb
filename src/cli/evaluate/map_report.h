#pragma once

#include <map>
#include <optional>
#include <string>

#include "structure_from_wifi/bssid.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Positions of access points, given or estimated, in the report.json beside a map.
/// @return none if there is no such file, or if `sfw map` did not write it
std::map<Bssid, Position> reportedPositions(const std::string& map);

/// Whether the report.json beside a map says that it was made without a table of access points.
bool isReportedWithoutTable(const std::string& map);

/// The settings in the report.json beside a map. Prints their warnings.
/// @return nothing if there is no such file, or if `sfw map` did not write it
/// @throw InputError naming the file if its settings are not valid in this version
std::optional<Config> reportedSettings(const std::string& map);

}  // namespace sfw
