#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/bench/bench_suite.h"

namespace sfw {

/// The result of one recording: a list of {"made_by", "metrics"}, one for each map.
struct BenchResult {
  std::size_t row = 0;  ///< of the suite
  BenchJob job;
  nlohmann::json maps;
};

/// A recording without a result, and the reason.
struct BenchFailure {
  std::size_t row = 0;  ///< of the suite
  BenchJob job;
  std::string reason;
};

/// All results of a benchmark, or those of a shard, in the order of the suite.
struct BenchReport {
  std::vector<BenchResult> results;
  std::vector<BenchFailure> failures;
};

/// A recording as the tables name it: {"plan", "noise", "path", "seed"}.
nlohmann::json toJson(const BenchJob& job);

/// Formats one table for each path: mean and standard deviation over plans and seeds, with a row
/// for each level and kind of map.
std::string toMarkdown(const BenchReport& report);

/// Formats the same tables with every metric, and then every recording.
std::string toJson(const BenchReport& report);

}  // namespace sfw
