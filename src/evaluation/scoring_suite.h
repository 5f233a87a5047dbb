#pragma once

#include <string>
#include <vector>

#include "evaluation/evaluation.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/config.h"

namespace sfw {

/// A method of the mapper, as the benchmark runs it. A new one is one more entry of
/// benchmarkMethods(): its controls follow by themselves.
struct BenchmarkMethod {
  std::string name;                ///< as `sfw bench --methods` has it, and the tables begin with
  std::string shipped;             ///< what the tables call its own map, e.g. "K-means k"
  bool maps_wall_counts;           ///< whether the true wall counts can be mapped in its way too
  void (*select)(Config& config);  ///< makes the settings those of this method
};

/// All methods, in the order of the tables.
std::vector<BenchmarkMethod> benchmarkMethods();

/// The methods of these names, in the order of the tables, each once; all if there are no
/// names.
/// @throw InputError naming one that there is not, and those that there are.
std::vector<BenchmarkMethod> benchmarkMethods(const std::vector<std::string>& names);

/// One map of a recording and how good it is.
struct BenchmarkFigures {
  std::string made_by;  ///< "k_visibility, K-means k", "path only", ...
  MapMetrics figures;
};

/// Maps one simulated recording in every way and judges the maps, in the order of the tables.
///
/// For each method: its map as shipped; where it maps wall counts, one of the true counts, which
/// is what better counts could give; and as controls one for each shift of the radio along the path
/// (kRadioShifts of one name) and one without any radio. Then two references that know no walls:
/// every cell that a ray crosses is free; the path alone, closed and grown as in evaluate().
///
/// @param config  settings for all methods, but for what selects them
/// @throw InputError as makeScenario, simulate and evaluate
std::vector<BenchmarkFigures> runBenchmark(const Scenario& scenario,
                                           const std::vector<BenchmarkMethod>& methods,
                                           const Config& config);

}  // namespace sfw
