// Measures the CPU time of a live refresh: a mapper that has mapped for a while gets the readings
// of a second, is copied, and infers a map, whose data are checked. Each iteration is one refresh.
//
// Usage: live_benchmark [REFRESHES]     of each drive (default: 30)

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "base/median.h"
#include "comparison.h"
#include "long_drive.h"
#include "structure_from_wifi/data_checks.h"

namespace sfw {
namespace {

/// The share of cells whose states differ in two maps of one grid.
double shareOfOtherStates(const BeliefMap& one, const BeliefMap& other) {
  const std::size_t cells = one.geometry().size();
  std::size_t differ = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    const Cell c = one.geometry().cell(i);
    differ += one.state(c) != other.state(c) ? 1 : 0;
  }
  return static_cast<double>(differ) / static_cast<double>(cells);
}

void measure(benchmark::State& state, double minutes, const Scenario& scenario,
             const std::vector<Reading>& readings) {
  const std::atomic<bool> never{false};
  Mapper mapper = mapperAfter(minutes, scenario, readings);
  RefreshCache cache;
  DataChecker checker;
  checker.checkChanged(*mapper.refresh(cache, never), never);
  double now_s = minutes * kMinute;
  std::vector<double> live_s, anew_s, share;
  while (state.KeepRunning()) {
    for (const Reading& reading : readingsBetween(now_s, now_s + 1.0, scenario, readings)) {
      mapper.insert(reading);
    }
    now_s += 1.0;
    std::shared_ptr<const Snapshot> live, anew;
    live_s.push_back(cpuSeconds([&] {
      const Mapper copy(mapper);
      live = copy.refresh(cache, never);
      return static_cast<double>(checker.checkChanged(*live, never).fits.size());
    }));
    state.PauseTiming();
    anew_s.push_back(cpuSeconds([&] {
      anew = mapper.infer(never);
      return static_cast<double>(anew->belief.geometry().size());
    }));
    share.push_back(shareOfOtherStates(live->belief, anew->belief));
    state.ResumeTiming();
  }
  state.counters["readings"] = static_cast<double>(mapper.readings().size());
  state.counters["live_ms"] = 1e3 * median(live_s);
  state.counters["anew_ms"] = 1e3 * median(anew_s);
  state.counters["other_states"] = *std::max_element(share.begin(), share.end());
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  return sfw::runBenchmarks(count, arguments, [](const std::vector<std::string>& options) {
    const auto scenario = std::make_shared<const sfw::Scenario>(sfw::longDrive());
    const auto recording =
        std::make_shared<const sfw::SimulatedRecording>(sfw::simulate(*scenario));
    for (const int minutes : {2, 10, 30, 199}) {
      const std::string name = "live/" + std::to_string(minutes) + " min";
      benchmark::RegisterBenchmark(name.c_str(),
                                   [=](benchmark::State& state) {
                                     sfw::measure(state, minutes, *scenario, recording->readings);
                                   })
          ->Iterations(options.empty() ? 30 : std::stoi(options.front()))
          ->Unit(benchmark::kMillisecond);
    }
  });
}
