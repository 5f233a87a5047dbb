#pragma once

#include <string>

#include "cli/recording_options.h"

namespace sfw {

/// Maps a recording and writes the files of the map. Prints warnings and notes.
/// @param directory  for the files; made if it is missing
/// @throw InputError if no map can be made; std::system_error if it cannot be written
void makeMap(const RecordingOptions& options, const std::string& directory);

}  // namespace sfw
