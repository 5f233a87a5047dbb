#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/evaluation.h"
#include "simulation/building/floor_plan.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/config.h"

namespace sfw {

/// A method of the mapper in the benchmark. For a new method add an entry to benchmarkMethods();
/// its ablations need no code.
struct BenchmarkMethod {
  std::string name;                ///< as in `sfw bench --methods` and in the tables
  std::string shipped;             ///< name of its own map in the tables, e.g. "K-means k"
  bool maps_wall_counts;           ///< whether it can also map the true wall counts
  void (*select)(Config& config);  ///< sets the settings of this method
};

/// All methods, in the order of the tables.
std::vector<BenchmarkMethod> benchmarkMethods();

/// The methods of these names, in the order of the tables, each once. No names select all methods.
/// @throw InputError naming an unknown method and the known ones.
std::vector<BenchmarkMethod> benchmarkMethods(const std::vector<std::string>& names);

/// Generates the building of a number: every third one is an office, and sizes range from 40 to
/// 140 m2. Deterministic.
FloorPlan makeBenchmarkBuilding(std::uint64_t number);

/// One map of a recording with its metrics.
struct BenchmarkMetrics {
  std::string made_by;  ///< "k_visibility, K-means k", "path only", ...
  MapMetrics metrics;
};

/// Maps one simulated recording by every method and scores the maps, in the order of the tables.
///
/// Each method gives its own map and its ablations: kRadioShifts maps with shifted signals, and one
/// without radio. A method that maps wall counts also maps the true counts, as an upper bound.
/// Two references without walls follow. In the first, every cell on a ray is free. The second is
/// the path alone, closed and grown as in evaluate().
///
/// @param config  settings for all methods, except those that select the method
/// @throw InputError as makeScenario, simulate and evaluate
std::vector<BenchmarkMetrics> runBenchmark(const Scenario& scenario,
                                           const std::vector<BenchmarkMethod>& methods,
                                           const Config& config);

}  // namespace sfw
