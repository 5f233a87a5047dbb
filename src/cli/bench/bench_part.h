#pragma once

#include <string>

#include "cli/bench/bench_run.h"
#include "cli/bench/bench_table.h"
#include "cli/shards/part.h"

namespace sfw {

/// The report of a shard as its part. @throw as runBench
Part partOf(const BenchReport& report, const BenchRun& run);

/// The report of a part. @throw nlohmann::json::exception if the part is damaged.
BenchReport reportOf(const Part& part);

/// @throw InputError if a recording failed, since the tables lack it.
void requireNoFailure(const BenchReport& report);

/// Writes bench.md and bench.json, and prints the tables.
/// @throw std::system_error naming a file that cannot be written; InputError if a recording failed
void finishBench(const BenchReport& report, const std::string& directory);

}  // namespace sfw
