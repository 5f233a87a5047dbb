#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/readings_io.h"

namespace sfw {

/// Prints a warning on standard error.
void warn(const std::string& text);

/// Reads a file of readings and warns of skipped rows, once for each reason.
/// @throw InputError as readReadings
ReadingFile readWithWarnings(const std::string& file);

}  // namespace sfw
