#pragma once

#include <string>

#include "cli/bench/bench_suite.h"
#include "cli/bench/bench_table.h"

namespace sfw {

/// How to run a benchmark.
struct BenchRun {
  BenchSuite suite;
  std::string config_file;   ///< settings of the mapper; may be empty
  std::int64_t workers = 1;  ///< threads
  std::string directory;     ///< where finished recordings are kept, and looked for
};

/// Runs all recordings of the suite but those that the directory holds already, under the same
/// plan, level, path, seed, access points, methods, settings and program. The report depends on the
/// run only, not on its workers or on how often it was interrupted.
/// @throw InputError for what makes the whole run senseless; std::system_error if results cannot be
/// kept. What is wrong with one recording is a failure in the report.
BenchReport runBench(const BenchRun& run);

}  // namespace sfw
