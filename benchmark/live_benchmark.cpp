// Measures the CPU time of a live refresh: a mapper that has mapped for a while gets the readings
// of a second, is copied, and infers a map, whose data are checked. Each iteration is one refresh.
//
// Usage: live_benchmark [REFRESHES]     of each drive (default: 30)

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "comparison.h"
#include "long_drive.h"
#include "structure_from_wifi/data_checks.h"

namespace sfw {
namespace {

void measure(benchmark::State& state, double minutes, const Scenario& scenario,
             const std::vector<Reading>& readings) {
  const std::atomic<bool> never{false};
  Mapper mapper = mapperAfter(minutes, scenario, readings);
  DataChecker checker;
  checker.checkChanged(*mapper.infer(), never);
  double now_s = minutes * kMinute;
  while (state.KeepRunning()) {
    for (const Reading& reading : readingsBetween(now_s, now_s + 1.0, scenario, readings)) {
      mapper.insert(reading);
    }
    now_s += 1.0;
    const Mapper copy(mapper);
    const std::shared_ptr<const Snapshot> snapshot = copy.infer(never);
    benchmark::DoNotOptimize(checker.checkChanged(*snapshot, never).fits.size());
  }
  state.counters["readings"] = static_cast<double>(mapper.readings().size());
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
