#include "evaluation/scoring_suite.h"

#include <algorithm>
#include <atomic>
#include <memory>

#include "base/erase_if.h"
#include "evaluation/ablations.h"
#include "grid/ray.h"
#include "k_visibility/sparse_inverse.h"
#include "simulation/building/floor_plan_generator.h"
#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {
namespace {

/// Makes and scores the maps of one recording.
class Benchmark {
 public:
  explicit Benchmark(const Scenario& scenario)
      : access_points_(scenario.access_points),
        recording_(simulate(scenario)),
        input_{toStates(scenario.plan), toStates(scenario.plan), {}, {}, {}} {
    for (const Reading& reading : recording_.readings) {
      if (input_.path.empty() || input_.path.back() != reading.antenna_in_map) {
        input_.path.push_back(reading.antenna_in_map);
      }
    }
    const NavigationSample sample{2000, 5};  // few, since tables average over drives
    input_.navigation =
        std::make_shared<const NavigationEvaluation>(input_.truth, input_.path, sample);
    for (const AccessPoint& access_point : access_points_) {
      input_.access_points.push_back(access_point.position);
    }
  }

  void run(const BenchmarkMethod& method, Config config) {
    method.select(config);
    const Mapper mapper = mapperOf(recording_.readings, access_points_, config);
    setMap(*mapper.infer(), input_);
    add(method.name + ", " + method.shipped, evaluate(input_).map);
    if (method.maps_wall_counts) {
      const BeliefMap belief = inferred(mapper, trueCounts(), config);
      setBelief(belief, belief, input_);
      add(method.name + ", true k", evaluate(input_).map);
    }
    const AblationMetrics ablations =
        evaluateAblations(input_, recording_.readings, access_points_, config);
    for (const MapMetrics& metrics : ablations.shifted_radio) {
      add(method.name + ", shifted radio", metrics);
    }
    add(method.name + ", no radio", ablations.no_radio);
  }

  void runReferences(const Config& config) {
    const BeliefMap belief =
        inferred(mapperOf(recording_.readings, access_points_, config), {}, config);
    setBelief(belief, belief, input_);
    freeEveryRay();
    const Evaluation evaluation = evaluate(input_);
    add("every ray is free", evaluation.map);
    add("path only", evaluation.path_only);
  }

  std::vector<BenchmarkMetrics> takeResults() { return std::move(results_); }

 private:
  void add(const std::string& made_by, const MapMetrics& metrics) {
    results_.push_back({made_by, metrics});
  }

  BeliefMap inferred(const Mapper& mapper, const std::vector<CountedPath>& counted,
                     const Config& config) const {
    const std::atomic<bool> never{false};
    return {inferOccupancy(mapper.geometry(), counted, input_.path, {}, sparseInverseConfig(config),
                           never),
            config.belief};
  }

  std::vector<CountedPath> trueCounts() const {
    std::vector<CountedPath> counted;
    for (const Position& access_point : input_.access_points) {
      counted.push_back({access_point, {}});
    }
    for (std::size_t i = 0; i < recording_.readings.size(); ++i) {
      const ReadingTruth& truth = recording_.truth[i];
      counted[truth.access_point].poses.push_back(
          {recording_.readings[i].antenna_in_map, truth.walls});
    }
    return counted;
  }

  void freeEveryRay() {
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

  const std::vector<AccessPoint> access_points_;
  const SimulatedRecording recording_;
  EvaluationInput input_;  // its map, probabilities and wall losses change
  std::vector<BenchmarkMetrics> results_;
};

}  // namespace

std::vector<BenchmarkMethod> benchmarkMethods() {
  return {
      {"tomography", "fused belief", false, [](Config& config) { config.method = "tomography"; }},
      {"k_visibility", "K-means k", true, [](Config& config) {
         config.method = "k_visibility";
         // The threshold of config/k_visibility.yaml, unless the user chose another.
         constexpr double kFreeThreshold = 0.35;
         if (config.belief.free_threshold == Config().belief.free_threshold) {
           config.belief.free_threshold = kFreeThreshold;
         }
       }}};
}

std::vector<BenchmarkMethod> benchmarkMethods(const std::vector<std::string>& names) {
  std::vector<BenchmarkMethod> methods = benchmarkMethods();
  std::string known;
  for (const BenchmarkMethod& method : methods) {
    known += (known.empty() ? "" : ", ") + method.name;
  }
  for (const std::string& name : names) {
    if (std::none_of(methods.begin(), methods.end(),
                     [&](const BenchmarkMethod& method) { return method.name == name; })) {
      throw InputError("methods: there is no '" + name + "'; there are: " + known);
    }
  }
  eraseIf(methods, [&](const BenchmarkMethod& method) {
    return !names.empty() && std::find(names.begin(), names.end(), method.name) == names.end();
  });
  return methods;
}

FloorPlan makeBenchmarkBuilding(std::uint64_t number) {
  BuildingConfig config;
  config.seed = number;
  config.kind = number % 3 == 0 ? BuildingKind::kOffice : BuildingKind::kFlat;
  config.area_m2 = 40.0 + 20.0 * static_cast<double>(number % 6);
  return generateFloorPlan(config);
}

std::vector<BenchmarkMetrics> runBenchmark(const Scenario& scenario,
                                           const std::vector<BenchmarkMethod>& methods,
                                           const Config& config) {
  Benchmark benchmark(scenario);
  for (const BenchmarkMethod& method : methods) {
    benchmark.run(method, config);
  }
  benchmark.runReferences(config);
  return benchmark.takeResults();
}

}  // namespace sfw
