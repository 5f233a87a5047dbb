#include <string>

#include "cli/bench/bench_part.h"
#include "cli/commands.h"
#include "cli/map/map_list_run.h"
#include "cli/shards/part.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {

void runMerge(Options& options) {
  std::string output;
  options.addRequired("output", "DIRECTORY", output,
                      "directory with the parts of all shards, shard-I-of-N.json, and their maps");
  if (!options.parse()) {
    return;
  }
  const Part part = mergedParts(output);
  try {
    if (part.work.at("command") == "bench") {
      finishBench(reportOf(part), output);
    } else {
      finishMapList(part, output);
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError(output + ": a part is damaged: " + error.what() + "; run its shard again");
  }
}

}  // namespace sfw
