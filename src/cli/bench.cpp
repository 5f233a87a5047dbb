#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <thread>

#include "bench_table.h"
#include "commands.h"
#include "structure_from_wifi/atomic_file.h"
#include "structure_from_wifi/benchmark.h"
#include "structure_from_wifi/config_reader.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/plan_generator.h"
#include "structure_from_wifi/plan_io.h"
#include "structure_from_wifi/scenario.h"
#include "warnings.h"

namespace sfw {
namespace {

struct BenchOptions {
  std::vector<std::string> plans;
  int generate = 0;
  std::vector<std::string> levels{"none", "low", "ideal", "realistic", "hard"};
  std::vector<std::string> paths{"walls"};
  std::int64_t seeds = 1;
  std::int64_t access_points = 1;
  std::string config;
  unsigned workers = std::max(1U, std::thread::hardware_concurrency());
  std::string output;
};

/// One recording of the benchmark.
struct Job {
  std::string plan;  // a file, or "generated N"
  std::string level;
  std::string path;
  std::int64_t seed;
};

/// Plan files below the names given: a directory stands for all plans in it, sorted.
std::vector<std::string> planFiles(const BenchOptions& options) {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const std::string& name : options.plans) {
    if (!fs::is_directory(name)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> inside;
    for (const fs::directory_entry& entry : fs::directory_iterator(name)) {
      if (entry.path().extension() == ".json" || entry.path().extension() == ".yaml") {
        inside.push_back(entry.path().string());
      }
    }
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  for (int i = 1; i <= options.generate; ++i) {
    files.push_back("generated " + std::to_string(i));
  }
  if (files.empty()) {
    throw InputError("bench needs --plan or --generate");
  }
  return files;
}

std::vector<Job> jobsOf(const BenchOptions& options) {
  std::vector<Job> jobs;
  for (const std::string& plan : planFiles(options)) {
    for (const std::string& level : options.levels) {
      for (const std::string& path : options.paths) {
        for (std::int64_t seed = 1; seed <= options.seeds; ++seed) {
          jobs.push_back({plan, level, path, seed});
        }
      }
    }
  }
  return jobs;
}

Plan planOf(const std::string& name) {
  constexpr char kGenerated[] = "generated ";
  if (name.rfind(kGenerated, 0) != 0) {
    return readPlan(name);
  }
  // Every third one an office, sizes from small flats to floors.
  PlanGeneratorConfig config;
  config.seed = std::stoull(name.substr(sizeof kGenerated - 1));
  config.kind = config.seed % 3 == 0 ? BuildingKind::kOffice : BuildingKind::kFlat;
  config.area = 40.0 + 20.0 * static_cast<double>(config.seed % 6);
  return generatePlan(config).plan;
}

BenchResult runJob(const Job& job, const BenchOptions& options, const Config& config) {
  ScenarioConfig scenario;
  scenario.level = parseNoiseLevel(job.level);
  scenario.path = job.path;
  scenario.seed = job.seed;
  scenario.access_points = options.access_points;
  return {job.plan, job.level, job.path, job.seed,
          runBenchmark(makeScenario(planOf(job.plan), {}, scenario), config)};
}

/// Runs all jobs on several threads; results stand in the order of the jobs.
std::vector<BenchResult> runAll(const std::vector<Job>& jobs, const BenchOptions& options,
                                const Config& config) {
  std::vector<BenchResult> results(jobs.size());
  std::vector<std::string> errors(jobs.size());
  std::atomic<std::size_t> next{0};
  std::atomic<std::size_t> done{0};
  std::mutex progress;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      try {
        results[i] = runJob(jobs[i], options, config);
      } catch (const std::exception& error) {
        errors[i] = error.what();
      }
      const std::lock_guard<std::mutex> lock(progress);
      showProgress(++done, jobs.size());
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 0; i < options.workers; ++i) {
    workers.emplace_back(work);
  }
  for (std::thread& worker : workers) {
    worker.join();
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!errors[i].empty()) {
      throw InputError(jobs[i].plan + ", " + jobs[i].level + ", " + jobs[i].path + ", seed " +
                       std::to_string(jobs[i].seed) + ": " + errors[i]);
    }
  }
  return results;
}

void run(const BenchOptions& options) {
  for (const std::string& level : options.levels) {
    parseNoiseLevel(level);
  }
  const Config config = options.config.empty() ? Config() : readConfig(options.config).config;
  const std::vector<BenchResult> results = runAll(jobsOf(options), options, config);
  makeDirectories(options.output);
  const std::string table = toMarkdown(results);
  writeAtomically(options.output + "/bench.json", toJson(results));
  writeAtomically(options.output + "/bench.md", table);
  std::cout << table;
}

}  // namespace

void addBenchCommand(CLI::App& sfw) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = sfw.add_subcommand(
      "bench",
      "Map many simulated recordings and print the figures beside references and controls.");
  command->add_option("--plan", options->plans, "plan files, or directories of them");
  command->add_option("--generate", options->generate, "buildings to make up")
      ->check(CLI::Range(0, 10000));
  command->add_option("--noise", options->levels, "none, low, ideal, realistic, hard")
      ->capture_default_str();
  command->add_option("--path", options->paths, "walls, sparse")->capture_default_str();
  command->add_option("--seeds", options->seeds, "seeds 1..N for each")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--access-points", options->access_points, "in each building")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command->add_option("--config", options->config, "settings as in config/mapping.yaml");
  command->add_option("--workers", options->workers, "threads")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--output", options->output, "directory for bench.md and bench.json")
      ->required();
  command->callback([options] { run(*options); });
}

}  // namespace sfw
