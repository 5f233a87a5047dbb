#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "cli/bench/bench_part.h"
#include "cli/bench/bench_run.h"
#include "cli/commands.h"
#include "cli/shards/shard.h"
#include "cli/warnings.h"
#include "simulation/radio/noise_level.h"

namespace sfw {
namespace {

/// Options of the command line. The suite file gives the others.
struct BenchOptions {
  std::string suite_file;
  std::vector<std::string> plans;
  std::optional<std::int64_t> generate;
  std::vector<std::string> levels;
  std::vector<std::string> paths;
  std::optional<std::int64_t> seeds;
  std::optional<std::int64_t> access_points;
  std::vector<std::string> methods;
  std::string config;
  std::int64_t workers = std::max(1U, std::thread::hardware_concurrency());
  std::string shard;
  std::string output;
};

void replaceIfGiven(const std::vector<std::string>& given, std::vector<std::string>& value) {
  if (!given.empty()) {
    value = given;
  }
}

BenchSuite suiteOf(const BenchOptions& options) {
  BenchSuite suite;
  if (!options.suite_file.empty()) {
    suite = readBenchSuite(options.suite_file);
  }
  if (!options.plans.empty() || options.generate) {  // the two select the buildings together
    suite.plans = options.plans;
    suite.generate = options.generate.value_or(0);
  }
  replaceIfGiven(options.levels, suite.levels);
  for (std::string& level : suite.levels) {
    if (const auto warning = oldNoiseLevelWarning(level)) {
      warn(*warning);
      level = noiseLevel(level).name;
    }
  }
  replaceIfGiven(options.paths, suite.paths);
  replaceIfGiven(options.methods, suite.methods);
  suite.seeds = options.seeds.value_or(suite.seeds);
  suite.access_points = options.access_points.value_or(suite.access_points);
  return suite;
}

void run(const BenchOptions& options, const Shard& shard) {
  const BenchRun bench{suiteOf(options), options.config, options.workers, shard, options.output};
  const BenchReport report = runBench(bench);
  if (bench.shard.count == 1) {
    finishBench(report, bench.directory);
    return;
  }
  writePart(partOf(report, bench), bench.shard, bench.directory);
  requireNoFailure(report);
}

}  // namespace

void runBench(Options& options) {
  BenchOptions bench;
  options.add(
      "suite", "FILE", bench.suite_file,
      "YAML with plans, generate, levels, paths, seeds, access_points, methods; the options "
      "below override it");
  options.addList("plan", "FILE", bench.plans, "floor plans, or directories of them");
  options.add("generate", "N", bench.generate, "number of buildings to generate");
  options.addList("noise", "LEVEL", bench.levels,
                  "noise levels; default: all of " + noiseLevelHelp());
  options.addList("path", "PATH", bench.paths,
                  "walls, sparse or files of way points; default: walls");
  options.add("seeds", "N", bench.seeds, "run seeds 1..N for each combination; default: 1");
  options.add("access-point-count", "N", bench.access_points,
              "number of access points in each building; default: 1");
  options.addOldName("access-points", "access-point-count");
  options.addList("methods", "METHOD", bench.methods,
                  "tomography, k_visibility; default: all of them");
  options.add("config", "FILE", bench.config, "settings as in config/mapping.yaml");
  options.addInRange("workers", bench.workers, 1, 256, "threads");
  addShard(options, bench.shard);
  options.addRequired("output", "DIRECTORY", bench.output,
                      "directory for bench.md, bench.json and the finished recordings");
  if (options.parse()) {
    run(bench, shardOf(options, bench.shard));
  }
}

}  // namespace sfw
