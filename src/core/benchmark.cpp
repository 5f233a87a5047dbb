#include "structure_from_wifi/benchmark.h"

#include <atomic>

#include "structure_from_wifi/belief_map.h"
#include "structure_from_wifi/inference.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/ray.h"

namespace sfw {
namespace {

constexpr int kShifts = 8;

/// A map to be judged.
struct Candidate {
  Grid<CellState> states;
  Grid<float> probabilities;
};

Candidate candidate(const BeliefMap& belief) {
  Candidate result{Grid<CellState>(belief.geometry()), Grid<float>(belief.geometry())};
  Cell c;
  for (c.y = 0; c.y < belief.geometry().height(); ++c.y) {
    for (c.x = 0; c.x < belief.geometry().width(); ++c.x) {
      result.states[c] = belief.state(c);
      result.probabilities[c] = belief.occupied(c);
    }
  }
  return result;
}

/// Makes and judges the maps of one recording.
class Benchmark {
 public:
  Benchmark(const Scenario& scenario, const Config& config)
      : scenario_(scenario), config_(config), recording_(simulate(scenario)) {
    for (const Reading& reading : recording_.readings) {
      if (path_.empty() || path_.back() != reading.antenna_in_map) {
        path_.push_back(reading.antenna_in_map);
      }
    }
    for (const AccessPoint& access_point : scenario.access_points) {
      access_points_.push_back(access_point.position);
    }
  }

  std::vector<std::pair<BenchmarkMethod, MapFigures>> run() {
    std::vector<std::pair<BenchmarkMethod, MapFigures>> results;
    const Evaluation shipped = judge(mapped(0));
    results.emplace_back(BenchmarkMethod::kKVisibility, shipped.map);
    results.emplace_back(BenchmarkMethod::kTrueCounts, judge(withTrueCounts()).map);
    for (int shift = 1; shift <= kShifts; ++shift) {
      results.emplace_back(BenchmarkMethod::kShiftedRadio, judge(mapped(shift)).map);
    }
    results.emplace_back(BenchmarkMethod::kNoRadio, judge(inferred({})).map);
    results.emplace_back(BenchmarkMethod::kAnyRay, judge(anyRay()).map);
    results.emplace_back(BenchmarkMethod::kPathOnly, shipped.path_only);
    return results;
  }

 private:
  GridGeometry geometry() const { return mapper(0).geometry(); }

  /// @param shift  ninths of the run by which each access point's signals are moved along the path
  Mapper mapper(int shift) const {
    Mapper mapper(config_, scenario_.access_points);
    for (const AccessPoint& access_point : scenario_.access_points) {
      std::vector<Reading> series;
      for (const Reading& reading : recording_.readings) {
        if (reading.bssid == access_point.bssid) {
          series.push_back(reading);
        }
      }
      const std::size_t offset = series.size() * static_cast<std::size_t>(shift) / (kShifts + 1);
      for (std::size_t i = 0; i < series.size(); ++i) {
        Reading reading = series[i];
        reading.rssi_dbm = series[(i + offset) % series.size()].rssi_dbm;
        mapper.insert(reading);
      }
    }
    return mapper;
  }

  Candidate mapped(int shift) const { return candidate(mapper(shift).infer()->belief); }

  Candidate inferred(const std::vector<CountedPath>& heard) const {
    const std::atomic<bool> never{false};
    return candidate(BeliefMap(
        inferOccupancy(geometry(), heard, path_, {}, config_.inference, never), config_.belief));
  }

  Candidate withTrueCounts() const {
    std::vector<CountedPath> heard;
    for (const Position& access_point : access_points_) {
      heard.push_back({access_point, {}});
    }
    for (std::size_t i = 0; i < recording_.readings.size(); ++i) {
      const ReadingTruth& truth = recording_.truth[i];
      heard[truth.access_point].poses.push_back(
          {recording_.readings[i].antenna_in_map, truth.walls});
    }
    return inferred(heard);
  }

  Candidate anyRay() const {
    Candidate result = inferred({});
    for (const Position& access_point : access_points_) {
      for (const Position& pose : path_) {
        Ray(result.states.geometry, access_point, pose).forEachCell([&](Cell c) {
          if (result.states.geometry.contains(c)) {
            result.states[c] = CellState::kFree;
          }
        });
      }
    }
    return result;
  }

  Evaluation judge(const Candidate& map) const {
    return evaluate(
        {map.states, toStates(scenario_.plan), path_, access_points_, map.probabilities});
  }

  const Scenario& scenario_;
  const Config& config_;
  SimulatedRecording recording_;
  std::vector<Position> path_;
  std::vector<Position> access_points_;
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
