#include "structure_from_wifi/benchmark.h"

#include <atomic>

#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/controls.h"
#include "structure_from_wifi/inference.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/ray.h"

namespace sfw {
namespace {

/// Makes and judges the maps of one recording.
class Benchmark {
 public:
  Benchmark(const Scenario& scenario, const Config& config)
      : scenario_(scenario),
        config_(config),
        recording_(simulate(scenario)),
        mapper_(config, scenario.access_points),
        input_{toStates(scenario.plan), toStates(scenario.plan), {}, {}, {}} {
    for (const Reading& reading : recording_.readings) {
      mapper_.insert(reading);
      if (input_.path.empty() || input_.path.back() != reading.antenna_in_map) {
        input_.path.push_back(reading.antenna_in_map);
      }
    }
    for (const AccessPoint& access_point : scenario.access_points) {
      input_.access_points.push_back(access_point.position);
    }
  }

  std::vector<std::pair<BenchmarkMethod, MapFigures>> run() {
    std::vector<std::pair<BenchmarkMethod, MapFigures>> results;
    setBelief(mapper_.infer()->belief, input_);
    const Evaluation shipped = evaluate(input_);
    results.emplace_back(BenchmarkMethod::kKVisibility, shipped.map);
    setBelief(withTrueCounts(), input_);
    results.emplace_back(BenchmarkMethod::kTrueCounts, evaluate(input_).map);
    const ControlFigures controls =
        evaluateControls(input_, recording_.readings, scenario_.access_points, config_);
    for (const MapFigures& figures : controls.shifted_radio) {
      results.emplace_back(BenchmarkMethod::kShiftedRadio, figures);
    }
    results.emplace_back(BenchmarkMethod::kNoRadio, controls.no_radio);
    freeEveryRay();
    results.emplace_back(BenchmarkMethod::kAnyRay, evaluate(input_).map);
    results.emplace_back(BenchmarkMethod::kPathOnly, shipped.path_only);
    return results;
  }

 private:
  BeliefMap inferred(const std::vector<CountedPath>& heard) const {
    const std::atomic<bool> never{false};
    return {inferOccupancy(mapper_.geometry(), heard, input_.path, {}, config_.inference, never),
            config_.belief};
  }

  BeliefMap withTrueCounts() const {
    std::vector<CountedPath> heard;
    for (const Position& access_point : input_.access_points) {
      heard.push_back({access_point, {}});
    }
    for (std::size_t i = 0; i < recording_.readings.size(); ++i) {
      const ReadingTruth& truth = recording_.truth[i];
      heard[truth.access_point].poses.push_back(
          {recording_.readings[i].antenna_in_map, truth.walls});
    }
    return inferred(heard);
  }

  void freeEveryRay() {
    setBelief(inferred({}), input_);
    for (const Position& access_point : input_.access_points) {
      for (const Position& pose : input_.path) {
        Ray(input_.map.geometry, access_point, pose).forEachCell([&](Cell c) {
          if (input_.map.geometry.contains(c)) {
            input_.map[c] = CellState::kFree;
          }
        });
      }
    }
  }

  const Scenario& scenario_;
  const Config& config_;
  SimulatedRecording recording_;
  Mapper mapper_;
  EvaluationInput input_;  // what changes is the map and its probabilities
};

}  // namespace

const std::vector<BenchmarkMethod>& benchmarkMethods() {
  static const std::vector<BenchmarkMethod> kMethods{
      BenchmarkMethod::kKVisibility, BenchmarkMethod::kTrueCounts, BenchmarkMethod::kShiftedRadio,
      BenchmarkMethod::kNoRadio,     BenchmarkMethod::kAnyRay,     BenchmarkMethod::kPathOnly};
  return kMethods;
}

const char* nameOf(BenchmarkMethod method) {
  switch (method) {
    case BenchmarkMethod::kKVisibility:
      return "k_visibility, K-means k";
    case BenchmarkMethod::kTrueCounts:
      return "k_visibility, true k";
    case BenchmarkMethod::kShiftedRadio:
      return "k_visibility, shifted radio";
    case BenchmarkMethod::kNoRadio:
      return "k_visibility, no radio";
    case BenchmarkMethod::kAnyRay:
      return "every ray is free";
    case BenchmarkMethod::kPathOnly:
      return "path only";
  }
  return "";
}

std::vector<std::pair<BenchmarkMethod, MapFigures>> runBenchmark(const Scenario& scenario,
                                                                 const Config& config) {
  return Benchmark(scenario, config).run();
}

}  // namespace sfw
