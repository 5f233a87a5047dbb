#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// The access points in the readings whose positions are known. Only they have rays.
///
/// The report.json beside the map gives positions that the table leaves out. Warns if none is
/// known.
/// @param table_file  name of the table, for messages
/// @throw InputError if no access point of the table is in the readings
std::vector<AccessPoint> locatedAccessPoints(std::vector<AccessPoint> table,
                                             const std::vector<Reading>& readings,
                                             const std::string& map, const std::string& table_file);

}  // namespace sfw
