#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "structure_from_wifi/reading_io.h"

namespace sfw {

/// Tells the user, on standard error, of something that does not stop the work.
void warn(const std::string& text);

/// Draws a progress bar if standard error is a terminal.
void showProgress(std::size_t done, std::size_t all);

/// Reads a file of readings; warns of the rows that are skipped, once for each reason.
/// @throw InputError as readReadings
std::vector<Reading> readWithWarnings(const std::string& file);

}  // namespace sfw
