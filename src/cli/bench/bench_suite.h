#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/radio/noise_level.h"

namespace sfw {

/// The recordings of a benchmark, as a suite file or options name them.
struct BenchSuite {
  std::vector<std::string> plans;  ///< files, or directories of them
  std::int64_t generate = 0;       ///< number of buildings to generate
  std::vector<std::string> levels = noiseLevelNames();
  std::vector<std::string> paths{"walls"};  ///< walls, sparse or files of way points
  std::int64_t seeds = 1;                   ///< seeds 1..N for each
  std::int64_t access_points = 1;           ///< in each building
  std::vector<std::string> methods;         ///< methods of the mapper; all if empty
};

/// One recording of a benchmark.
struct BenchJob {
  std::string plan;  // a file, or "generated N"
  std::string level;
  std::string path;
  std::int64_t seed = 0;
};

/// Reads a YAML file with values for some members; the others keep their defaults. Plans and files
/// of way points are relative to the file.
/// @throw InputError naming file and key: unreadable, of a wrong type or unknown.
BenchSuite readBenchSuite(const std::string& file);

/// Every recording of the suite, in the order of the tables.
/// @throw InputError naming every problem of the suite.
std::vector<BenchJob> jobsOf(const BenchSuite& suite);

/// "PLAN, LEVEL, PATH, seed N"
std::string toText(const BenchJob& job);

}  // namespace sfw
