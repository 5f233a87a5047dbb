#pragma once

#include <string>
#include <vector>

#include "cli/recording_options.h"

namespace sfw {

/// A recording of a work list.
struct MapRow {
  std::string name;  ///< of its directory
  RecordingOptions recording;
};

/// Reads a YAML list of maps. Their keys are `name` and the options of `sfw map`, written with
/// underscores. File names are relative to the list.
/// @param shared  the options of rows that do not give their own
/// @throw InputError naming the file and the line of each row that cannot be used: its keys are
/// wrong, or its name is missing, no name of a directory, or that of another row. Files that the
/// rows name are not read.
std::vector<MapRow> readMapList(const std::string& file, const RecordingOptions& shared);

}  // namespace sfw
