#pragma once

#include <string>
#include <utility>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/evaluation.h"
#include "structure_from_wifi/scenario.h"

namespace sfw {

/// A way to make a map of a recording, for the benchmark's table.
enum class BenchmarkMethod {
  kKVisibility,   ///< as shipped: wall counts by K-means
  kTrueCounts,    ///< the same inference with the true wall counts: what better counts could give
  kShiftedRadio,  ///< control: signal strengths moved along the path by 1/9 .. 8/9 of the run
  kNoRadio,       ///< control: the same method with no signal at all, that is Rule 1
  kAnyRay,        ///< reference: every cell that a ray crosses is free
  kPathOnly       ///< reference: the path closed and grown, as in evaluate()
};

/// All methods in the order of the table.
const std::vector<BenchmarkMethod>& benchmarkMethods();

const char* nameOf(BenchmarkMethod method);

/// The figures of each method on one simulated recording; kShiftedRadio comes eight times.
/// @throw InputError as makeScenario, simulate and evaluate
std::vector<std::pair<BenchmarkMethod, MapFigures>> runBenchmark(const Scenario& scenario,
                                                                 const Config& config);

}  // namespace sfw
