#include <chrono>
#include <iostream>
#include <string>

#include "cli/commands.h"
#include "cli/map/made_map.h"
#include "cli/map/map_list.h"
#include "cli/map/map_list_run.h"
#include "cli/recording_options.h"
#include "cli/shards/shard.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

void mapOne(const RecordingOptions& recording, const std::string& output) {
  const auto start = std::chrono::steady_clock::now();
  makeMap(recording, output);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cerr << "sfw: wrote the map to " << output << " in "
            << static_cast<int>(elapsed.count() * 1000) << " ms\n";
}

void mapList(const Options& options, const std::string& list, const RecordingOptions& shared,
             const Shard& shard, const std::string& output) {
  for (const char* name : {"readings", "bag", "contacts", "path"}) {
    if (options.given(name)) {
      throw InputError("--" + std::string(name) + " differs from drive to drive; write it into " +
                       list);
    }
  }
  runMapList({list, shared, shard, output});
}

}  // namespace

void runMap(Options& options) {
  RecordingOptions recording;
  std::string list;
  std::string shard;
  std::string output;
  recording.declare(options);
  options.add("list", "FILE", list,
              "YAML list of recordings to map, each {name, ...} with options of this command as "
              "keys; the options given here hold for all. A run that was interrupted goes on");
  addShard(options, shard);
  options.addRequired("output", "DIRECTORY", output,
                      "directory for the files of the map; with --list, for a directory of each "
                      "name");
  if (!options.parse()) {
    return;
  }
  if (options.given("list")) {
    mapList(options, list, recording, shardOf(options, shard), output);
    return;
  }
  if (options.given("shard")) {
    throw InputError("--shard goes with --list");
  }
  recording.check();
  mapOne(recording, output);
}

}  // namespace sfw
