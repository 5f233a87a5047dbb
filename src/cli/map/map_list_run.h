#pragma once

#include <string>

#include "cli/recording_options.h"
#include "cli/shards/part.h"
#include "cli/shards/shard.h"

namespace sfw {

/// Settings of a run over a work list.
struct MapListRun {
  std::string list;         ///< its file
  RecordingOptions shared;  ///< options of the command line, for all rows
  Shard shard;
  std::string directory;  ///< of the maps
};

/// Makes the map of each row of the shard, each in the directory of its name. Leaves whole maps of
/// the same origin as they are. A recording that cannot be mapped does not stop the others.
/// @throw InputError if the list is unusable, or at the end if a row failed; std::system_error if
/// a map cannot be written
void runMapList(const MapListRun& run);

/// Checks the maps of merged parts and writes their index, maps.json.
/// @throw nlohmann::json::exception if the part is damaged
/// @throw InputError if a map is missing or damaged, if rows were made from different contents of
/// one file, or if a row failed
void finishMapList(const Part& part, const std::string& directory);

}  // namespace sfw
