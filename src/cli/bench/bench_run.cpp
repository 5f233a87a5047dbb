#include "cli/bench/bench_run.h"

#include <exception>
#include <filesystem>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include "cli/bench/bench_store.h"
#include "cli/evaluate/metrics.h"
#include "cli/hash.h"
#include "cli/parallel_for.h"
#include "cli/progress.h"
#include "cli/shards/work_lock.h"
#include "cli/warnings.h"
#include "evaluation/scoring_suite.h"
#include "files/text.h"
#include "simulation/building/floor_plan_io.h"
#include "simulation/scenario.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

FloorPlan planOf(const std::string& name) {
  constexpr char kGenerated[] = "generated ";
  if (name.rfind(kGenerated, 0) != 0) {
    return readFloorPlan(name);
  }
  return makeBenchmarkBuilding(std::stoull(name.substr(sizeof kGenerated - 1)));
}

/// Inputs that all recordings of a run share.
struct SharedInputs {
  std::int64_t access_points = 1;
  std::vector<BenchmarkMethod> methods;
  Config config;
  std::string config_text;
  std::uint64_t program = 0;
};

SharedInputs sharedInputsOf(const BenchRun& run) {
  SharedInputs shared;
  shared.access_points = run.suite.access_points;
  shared.methods = benchmarkMethods(run.suite.methods);
  shared.program = hashOfProgram();
  if (!run.config_file.empty()) {
    shared.config = configWithWarnings(run.config_file);
    shared.config_text = readFile(run.config_file);
  }
  return shared;
}

/// Everything that a result depends on.
std::string keyOf(const BenchJob& job, const FloorPlan& plan, const SharedInputs& shared) {
  Json key{{"plan", hashOf(plan)},
           {"noise", job.level},
           {"path", std::filesystem::exists(job.path) ? readFile(job.path) : job.path},
           {"seed", job.seed},
           {"access_points", shared.access_points},
           {"config", shared.config_text},
           {"program", shared.program}};
  for (const BenchmarkMethod& method : shared.methods) {
    key["methods"].push_back(method.name);
  }
  return key.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string mapsOf(const BenchJob& job, const FloorPlan& plan, const SharedInputs& shared) {
  ScenarioConfig scenario;
  scenario.noise = noiseLevel(job.level);
  scenario.path = job.path;
  scenario.seed = job.seed;
  scenario.access_points = shared.access_points;
  Json maps = Json::array();
  for (const BenchmarkMetrics& map :
       runBenchmark(makeScenario(plan, {}, scenario), shared.methods, shared.config)) {
    maps.push_back({{"made_by", map.made_by}, {"metrics", metricsJson(map.metrics)}});
  }
  return maps.dump();
}

/// The recordings of a shard, mapped by several threads.
class Bench {
 public:
  explicit Bench(const BenchRun& run)
      : jobs_(jobsOf(run.suite)),
        shared_(sharedInputsOf(run)),
        rows_(run.shard.rowsOf(jobs_.size())),
        store_(run.directory + "/recordings"),
        lock_(run.directory, run.shard, [this] { store_.removeUnfinished(); }),
        maps_(rows_.size()),
        reasons_(rows_.size()),
        progress_(rows_.size()) {}

  BenchReport report(std::int64_t workers) {
    parallelFor(rows_.size(), workers, [this](std::size_t i) { work(i); });
    BenchReport report;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const BenchJob& job = jobs_[rows_[i]];
      if (reasons_[i].empty()) {
        report.results.push_back({rows_[i], job, std::move(maps_[i])});
      } else {
        report.failures.push_back({rows_[i], job, reasons_[i]});
      }
    }
    return report;
  }

 private:
  void work(std::size_t i) {
    bool at_once = false;
    try {
      at_once = runJob(i);
    } catch (const std::system_error&) {
      throw;  // no later result could be stored either
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& error) {
      reasons_[i] = error.what();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    progress_.add(at_once);
  }

  /// @return whether the result was there already
  bool runJob(std::size_t i) {
    const BenchJob& job = jobs_[rows_[i]];
    const FloorPlan plan = planOf(job.plan);
    const std::string key = keyOf(job, plan, shared_);
    std::optional<std::string> maps = store_.find(key);
    const bool at_once = maps.has_value();
    if (!at_once) {
      maps = mapsOf(job, plan, shared_);
      store_.save(key, *maps);
    }
    maps_[i] = Json::parse(*maps);  // new results too, so that they equal stored ones
    return at_once;
  }

  const std::vector<BenchJob> jobs_;
  const SharedInputs shared_;
  const std::vector<std::size_t> rows_;  // places of the shard's jobs
  const BenchStore store_;
  const WorkLock lock_;
  std::vector<Json> maps_;
  std::vector<std::string> reasons_;  // why a job failed; empty if it did not
  std::mutex mutex_;                  // of the progress
  Progress progress_;
};

}  // namespace

BenchReport runBench(const BenchRun& run) { return Bench(run).report(run.workers); }

}  // namespace sfw
