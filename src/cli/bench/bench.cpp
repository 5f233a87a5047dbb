#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "cli/bench/bench_run.h"
#include "cli/commands.h"
#include "files/atomic_file.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// What the command line says; the suite file has the rest.
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
  unsigned workers = std::max(1U, std::thread::hardware_concurrency());
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
  if (!options.plans.empty() || options.generate) {  // together they say which buildings
    suite.plans = options.plans;
    suite.generate = options.generate.value_or(0);
  }
  replaceIfGiven(options.levels, suite.levels);
  replaceIfGiven(options.paths, suite.paths);
  replaceIfGiven(options.methods, suite.methods);
  suite.seeds = options.seeds.value_or(suite.seeds);
  suite.access_points = options.access_points.value_or(suite.access_points);
  return suite;
}

/// @throw InputError if a recording failed: the tables are not what was asked for.
void requireNoFailure(const BenchReport& report) {
  if (report.failures.empty()) {
    return;
  }
  std::string text = std::to_string(report.failures.size()) + " of " +
                     std::to_string(report.failures.size() + report.results.size()) +
                     " recordings failed; the tables are without them:";
  for (const BenchFailure& failure : report.failures) {
    text += "\n" + toText(failure.job) + ": " + failure.reason;
  }
  throw InputError(text);
}

void run(const BenchOptions& options) {
  const BenchReport report =
      runBench({suiteOf(options), options.config, options.workers, options.output + "/recordings"});
  const std::string table = toMarkdown(report);
  writeAtomically(
      {{options.output + "/bench.json", toJson(report)}, {options.output + "/bench.md", table}});
  std::cout << table << std::flush;
  requireNoFailure(report);
}

}  // namespace

void addBenchCommand(CLI::App& sfw) {
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = sfw.add_subcommand(
      "bench",
      "Map many simulated recordings and print the figures beside references and controls. Run "
      "again after an interruption, it goes on where it stopped.");
  command->add_option("--suite", options->suite_file,
                      "YAML with plans, generate, levels, paths, seeds, access_points, methods; "
                      "the options below go before it");
  command->add_option("--plan", options->plans, "plan files, or directories of them");
  command->add_option("--generate", options->generate, "buildings to make up");
  command->add_option("--noise", options->levels,
                      "none, low, ideal, realistic, hard; all of them if left out");
  command->add_option("--path", options->paths,
                      "walls, sparse or files of way points; walls if left out");
  command->add_option("--seeds", options->seeds, "seeds 1..N for each; 1 if left out");
  command->add_option("--access-points", options->access_points, "in each building; 1 if left out");
  command->add_option("--methods", options->methods, "the mapper's methods; all if left out");
  command->add_option("--config", options->config, "settings as in config/mapping.yaml");
  command->add_option("--workers", options->workers, "threads")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command
      ->add_option("--output", options->output,
                   "directory for bench.md, bench.json, and the recordings that are done")
      ->required();
  command->callback([options] { run(*options); });
}

}  // namespace sfw
