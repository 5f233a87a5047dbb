#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/readings_io.h"

namespace sfw {

/// Tells the user, on standard error, of something that does not stop the work.
void warn(const std::string& text);

/// Reads a file of readings; warns of the rows that are skipped, once for each reason.
/// @throw InputError as readReadings
ReadingFile readWithWarnings(const std::string& file);

}  // namespace sfw
