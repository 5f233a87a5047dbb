#include "cli/bench/bench_run.h"

#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>

#include "cli/bench/bench_store.h"
#include "cli/evaluate/figures.h"
#include "cli/progress.h"
#include "evaluation/scoring_suite.h"
#include "simulation/building/floor_plan_generator.h"
#include "simulation/building/floor_plan_io.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/settings_io.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

FloorPlan planOf(const std::string& name) {
  constexpr char kGenerated[] = "generated ";
  if (name.rfind(kGenerated, 0) != 0) {
    return readFloorPlan(name);
  }
  // Every third one an office, sizes from small flats to floors.
  BuildingConfig config;
  config.seed = std::stoull(name.substr(sizeof kGenerated - 1));
  config.kind = config.seed % 3 == 0 ? BuildingKind::kOffice : BuildingKind::kFlat;
  config.area_m2 = 40.0 + 20.0 * static_cast<double>(config.seed % 6);
  return generateFloorPlan(config);
}

/// What all recordings of a run share.
struct Setting {
  std::int64_t access_points = 1;
  std::vector<BenchmarkMethod> methods;
  Config config;
  std::string config_text;
  std::uint64_t program = 0;
};

Setting settingOf(const BenchRun& run) {
  Setting setting;
  setting.access_points = run.suite.access_points;
  setting.methods = benchmarkMethods(run.suite.methods);
  setting.program = hashOfProgram();
  if (!run.config_file.empty()) {
    setting.config = readConfig(run.config_file).config;
    setting.config_text = bytesOf(run.config_file);
  }
  return setting;
}

/// Everything that decides what a recording comes to.
std::string keyOf(const BenchJob& job, const FloorPlan& plan, const Setting& setting) {
  Json key{{"plan", hashOf(plan)},
           {"noise", job.level},
           {"path", std::filesystem::exists(job.path) ? bytesOf(job.path) : job.path},
           {"seed", job.seed},
           {"access_points", setting.access_points},
           {"config", setting.config_text},
           {"program", setting.program}};
  for (const BenchmarkMethod& method : setting.methods) {
    key["methods"].push_back(method.name);
  }
  return key.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string mapsOf(const BenchJob& job, const FloorPlan& plan, const Setting& setting) {
  ScenarioConfig scenario;
  scenario.noise = noiseLevel(job.level);
  scenario.path = job.path;
  scenario.seed = job.seed;
  scenario.access_points = setting.access_points;
  Json maps = Json::array();
  for (const BenchmarkFigures& map :
       runBenchmark(makeScenario(plan, {}, scenario), setting.methods, setting.config)) {
    maps.push_back({{"made_by", map.made_by}, {"figures", metricsJson(map.figures)}});
  }
  return maps.dump();
}

/// The recordings of a run, worked through by several threads.
class Bench {
 public:
  explicit Bench(const BenchRun& run)
      : jobs_(jobsOf(run.suite)),
        setting_(settingOf(run)),
        store_(run.directory),
        maps_(jobs_.size()),
        reasons_(jobs_.size()),
        progress_(jobs_.size()) {}

  BenchReport report(std::int64_t workers) {
    std::vector<std::thread> threads;
    for (std::int64_t i = 0; i < workers; ++i) {
      threads.emplace_back([this] { work(); });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    if (broken_) {
      std::rethrow_exception(broken_);
    }
    BenchReport report;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      if (reasons_[i].empty()) {
        report.results.push_back({jobs_[i], std::move(maps_[i])});
      } else {
        report.failures.push_back({jobs_[i], reasons_[i]});
      }
    }
    return report;
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < jobs_.size() && !stop_; i = next_++) {
      bool at_once = false;
      try {
        at_once = runJob(i);
      } catch (const std::system_error&) {
        breakOff();  // nothing that follows could be kept either
      } catch (const std::bad_alloc&) {
        breakOff();
      } catch (const std::exception& error) {
        reasons_[i] = error.what();
      }
      const std::lock_guard<std::mutex> lock(mutex_);
      progress_.add(at_once);
    }
  }

  /// @return whether the result was there already
  bool runJob(std::size_t i) {
    const FloorPlan plan = planOf(jobs_[i].plan);
    const std::string key = keyOf(jobs_[i], plan, setting_);
    std::optional<std::string> maps = store_.find(key);
    const bool at_once = maps.has_value();
    if (!at_once) {
      maps = mapsOf(jobs_[i], plan, setting_);
      store_.save(key, *maps);
    }
    maps_[i] = Json::parse(*maps);  // fresh results too, so that both are the same
    return at_once;
  }

  void breakOff() {
    const std::lock_guard<std::mutex> lock(mutex_);
    broken_ = std::current_exception();
    stop_ = true;
  }

  const std::vector<BenchJob> jobs_;
  const Setting setting_;
  const BenchStore store_;
  std::vector<Json> maps_;
  std::vector<std::string> reasons_;  // why a job failed; empty if it did not
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  Progress progress_;
  std::exception_ptr broken_;
};

}  // namespace

BenchReport runBench(const BenchRun& run) { return Bench(run).report(run.workers); }

}  // namespace sfw
