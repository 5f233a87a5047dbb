#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/readings_io.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Prints a warning on standard error.
void warn(const std::string& text);

/// Reads a file of readings and warns of skipped rows, once for each reason.
/// @param path  file of the path; may be empty
/// @throw InputError as readReadings
ReadingFile readWithWarnings(const std::string& file, const std::string& path);

/// Reads settings and prints their warnings; the defaults if there is no file.
/// @param file  may be empty
/// @throw InputError as readConfig
Config configWithWarnings(const std::string& file);

/// Reads a table of access points and prints its warnings.
/// @throw InputError as readAccessPoints
std::vector<AccessPoint> accessPointsWithWarnings(const std::string& file);

}  // namespace sfw
