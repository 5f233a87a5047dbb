#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/bench/bench_suite.h"

namespace sfw {

/// What one recording of a benchmark came to: a list of {"made_by", "figures"}, one for each map.
struct BenchResult {
  BenchJob job;
  nlohmann::json maps;
};

/// A recording that came to nothing, and why.
struct BenchFailure {
  BenchJob job;
  std::string reason;
};

/// What a benchmark came to.
struct BenchReport {
  std::vector<BenchResult> results;
  std::vector<BenchFailure> failures;
};

/// One table for each path: mean and standard deviation over plans and seeds, a row for each level
/// and kind of map.
std::string toMarkdown(const BenchReport& report);

/// The same tables with every figure, then every recording by itself.
std::string toJson(const BenchReport& report);

}  // namespace sfw
