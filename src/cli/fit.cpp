#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "commands.h"
#include "plan_files.h"
#include "progress.h"
#include "structure_from_wifi/atomic_file.h"
#include "structure_from_wifi/belief_training.h"
#include "structure_from_wifi/config_reader.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/plan_generator.h"
#include "structure_from_wifi/plan_io.h"
#include "structure_from_wifi/random.h"

namespace sfw {
namespace {

struct FitOptions {
  std::vector<std::string> plans;
  std::size_t drives = 300;
  std::size_t cells = 2500;
  std::int64_t seed = 1;
  std::string config;
  unsigned workers = std::max(1U, std::thread::hardware_concurrency());
  std::string output;
};

/// Every second building is made up; the others are the plans given, in turn.
Plan buildingFor(std::size_t drive, std::int64_t seed, const std::vector<Plan>& plans) {
  if (!plans.empty() && drive % 2 == 1) {
    return plans[drive / 2 % plans.size()];
  }
  constexpr std::uint64_t kStream = 0x666974;  // apart from the streams of simulations
  Random random(seed, kStream, 0);
  PlanGeneratorConfig config;
  config.seed = static_cast<std::uint64_t>(seed);
  config.kind = random.uniform() < 0.25 ? BuildingKind::kOffice : BuildingKind::kFlat;
  config.area = random.uniform(35.0, 135.0);
  config.rotation_rad = random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 1.57);
  return generatePlan(config).plan;
}

/// Cells of drives of one style, made on several threads, in the order of the drives.
class Drives {
 public:
  Drives(const FitOptions& options, const std::vector<Plan>& plans, const Config& config)
      : options_(options), plans_(plans), config_(config), progress_(2 * options.drives) {}

  TrainingCells make(DrivingStyle style) {
    std::vector<std::optional<TrainingCells>> parts(options_.drives);
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < options_.workers; ++i) {
      workers.emplace_back([&] {
        for (std::size_t drive = next++; drive < parts.size(); drive = next++) {
          parts[drive] = makeOne(style, drive);
          const std::lock_guard<std::mutex> lock(mutex_);
          progress_.add();
        }
      });
    }
    for (std::thread& worker : workers) {
      worker.join();
    }
    TrainingCells all;
    for (const std::optional<TrainingCells>& part : parts) {
      if (part) {
        all.cells.insert(all.cells.end(), part->cells.begin(), part->cells.end());
        all.free.insert(all.free.end(), part->free.begin(), part->free.end());
        all.styles.insert(all.styles.end(), part->styles.begin(), part->styles.end());
      }
    }
    return all;
  }

 private:
  std::optional<TrainingCells> makeOne(DrivingStyle style, std::size_t drive) const {
    const auto number = static_cast<std::int64_t>(drive);
    const std::int64_t kind = style == DrivingStyle::kAlongWalls ? 0 : 1;
    const std::int64_t seed =
        options_.seed * 1000000 + 2 * number + kind;  // no two drives share one
    const std::optional<TrainingDrive> made =
        makeTrainingDrive(buildingFor(drive, seed, plans_), style, seed);
    return made ? std::optional(cellsOf(*made, config_, options_.cells, seed)) : std::nullopt;
  }

  const FitOptions& options_;
  const std::vector<Plan>& plans_;
  const Config& config_;
  std::mutex mutex_;  // of the progress
  Progress progress_;
};

std::string describe(const FitOptions& options, const TrainingCells& along,
                     const TrainingCells& any) {
  std::string text =
      "# What is believed of a cell, from its features (doc/algorithm.md). Fitted to simulated "
      "drives alone:\n"
      "# sfw fit --drives " +
      std::to_string(options.drives) + " --cells " + std::to_string(options.cells) + " --seed " +
      std::to_string(options.seed);
  for (const std::string& plan : planFiles(options.plans)) {
    text += " \\\n#   --plan " + std::filesystem::path(plan).filename().string();
  }
  return text + "\n# " + std::to_string(along.styles.size()) + " drives along walls with " +
         std::to_string(along.cells.size()) + " cells, " + std::to_string(any.styles.size()) +
         " other drives with " + std::to_string(any.cells.size()) + " cells.\n";
}

void run(const FitOptions& options) {
  const Config config = options.config.empty() ? Config() : readConfig(options.config).config;
  std::vector<Plan> plans;
  for (const std::string& file : planFiles(options.plans)) {
    plans.push_back(readPlan(file));
  }
  Drives drives(options, plans, config);
  const TrainingCells along = drives.make(DrivingStyle::kAlongWalls);
  const TrainingCells any = drives.make(DrivingStyle::kAnyPath);
  const BeliefModel model(fitExpert(along), fitExpert(any));
  writeAtomically(options.output, describe(options, along, any) + toYaml(model));
}

}  // namespace

void addFitCommand(CLI::App& sfw) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* command = sfw.add_subcommand(
      "fit", "Fit the belief model to simulated drives; the file is for belief/model.");
  command->add_option("--plan", options->plans,
                      "plan files or directories for every second drive, beside buildings made up");
  command->add_option("--drives", options->drives, "of each of the two styles")
      ->check(CLI::Range(10, 100000))
      ->capture_default_str();
  command->add_option("--cells", options->cells, "of each drive, about")
      ->check(CLI::Range(10, 1000000))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "of all that is random")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command->add_option("--config", options->config, "settings as in config/mapping.yaml");
  command->add_option("--workers", options->workers, "threads")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_option("--output", options->output, "file for the model (YAML)")->required();
  command->callback([options] { run(*options); });
}

}  // namespace sfw
