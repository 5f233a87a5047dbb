#pragma once

#include <string>

#include "cli/bench/bench_suite.h"
#include "cli/bench/bench_table.h"
#include "cli/shards/shard.h"

namespace sfw {

/// Settings of a run of the benchmark.
struct BenchRun {
  BenchSuite suite;
  std::string config_file;   ///< settings of the mapper; may be empty
  std::int64_t workers = 1;  ///< threads
  Shard shard;
  std::string directory;  ///< of the output; keeps finished recordings
};

/// Runs the recordings of the suite that belong to the shard. Reuses a result of the directory if
/// plan, level, path, seed, access points, methods, settings and program are the same. The report
/// depends only on the run, not on its workers or interruptions.
/// @throw InputError if the suite or the settings are unusable, or if another worker makes the
/// shard; std::system_error if results cannot be kept. The error of a single recording becomes a
/// failure in the report.
BenchReport runBench(const BenchRun& run);

}  // namespace sfw
