#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "structure_from_wifi/benchmark.h"

namespace sfw {

/// What one recording of a benchmark came to.
struct BenchResult {
  std::string plan;
  std::string level;
  std::string path;
  std::int64_t seed = 0;
  std::vector<std::pair<BenchmarkMethod, MapFigures>> figures;
};

/// One table for each path: mean and standard deviation over plans and seeds, a row for each level
/// and method.
std::string toMarkdown(const std::vector<BenchResult>& results);

/// Every figure of every recording.
std::string toJson(const std::vector<BenchResult>& results);

}  // namespace sfw
