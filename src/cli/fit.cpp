#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "cli/commands.h"
#include "cli/floor_plan_files.h"
#include "cli/parallel_for.h"
#include "cli/progress.h"
#include "cli/warnings.h"
#include "files/atomic_file.h"
#include "simulation/building/floor_plan_io.h"
#include "structure_from_wifi/input_error.h"
#include "training/belief_training.h"
#include "training/training_world.h"

namespace sfw {
namespace {

struct FitOptions {
  std::vector<std::string> plans;
  std::int64_t drives = 300;
  std::int64_t cells = 2500;
  std::int64_t seed = 1;
  std::string config;
  std::int64_t workers = std::max(1U, std::thread::hardware_concurrency());
  std::string output;
};

/// Generates every second building and takes the given plans in turn for the others.
FloorPlan buildingFor(std::size_t drive, std::int64_t seed, const std::vector<FloorPlan>& plans) {
  if (!plans.empty() && drive % 2 == 1) {
    return plans[drive / 2 % plans.size()];
  }
  return makeTrainingBuilding(seed);
}

/// Simulates drives on several threads.
class Drives {
 public:
  Drives(const FitOptions& options, const std::vector<FloorPlan>& plans, const Config& config)
      : options_(options), plans_(plans), config_(config), progress_(count()) {}

  /// Returns labelled cells of all drives. Their order does not depend on the threads.
  std::vector<TrainingCells> make() {
    std::vector<std::optional<TrainingCells>> made(count());
    parallelFor(made.size(), options_.workers, [&](std::size_t drive) {
      made[drive] = makeOne(drive);
      const std::lock_guard<std::mutex> lock(mutex_);
      progress_.add();
    });
    std::vector<TrainingCells> drives;
    for (std::optional<TrainingCells>& drive : made) {
      if (drive) {
        drives.push_back(std::move(*drive));
      }
    }
    return drives;
  }

 private:
  std::size_t count() const { return kDrivingStyles * static_cast<std::size_t>(options_.drives); }

  std::optional<TrainingCells> makeOne(std::size_t drive) const {
    const auto style = static_cast<DrivingStyle>(drive % kDrivingStyles);
    constexpr std::int64_t kSeeds = 1000000;  // no two drives share one
    const std::int64_t seed = options_.seed * kSeeds + static_cast<std::int64_t>(drive);
    const std::optional<TrainingDrive> made =
        makeTrainingDrive(buildingFor(drive / kDrivingStyles, seed, plans_), style, seed);
    return made ? std::optional(drawTrainingCells(*made, config_,
                                                  static_cast<std::size_t>(options_.cells), seed))
                : std::nullopt;
  }

  const FitOptions& options_;
  const std::vector<FloorPlan>& plans_;
  const Config& config_;
  std::mutex mutex_;  // of the progress
  Progress progress_;
};

std::string describe(const FitOptions& options, const std::vector<TrainingCells>& drives) {
  std::string text =
      "# Weights of the features of a cell (doc/method/belief.md), fitted to simulated drives:\n"
      "# sfw fit --drives " +
      std::to_string(options.drives) + " --cells " + std::to_string(options.cells) + " --seed " +
      std::to_string(options.seed);
  for (const std::string& plan : floorPlanFiles(options.plans)) {
    text += " \\\n#   --plan " + std::filesystem::path(plan).filename().string();
  }
  std::array<std::size_t, kDrivingStyles> count{};
  std::size_t cells = 0;
  for (const TrainingCells& drive : drives) {
    ++count[static_cast<std::size_t>(drive.made)];
    cells += drive.cells.size();
  }
  text += "\n# Drives:";
  for (std::size_t i = 0; i < kDrivingStyles; ++i) {
    text += ' ' + std::to_string(count[i]) + ' ' + kDrivingStyleNames[i] + ',';
  }
  return text + " with " + std::to_string(cells) + " cells.\n";
}

/// Checks before the fit, which takes minutes, that its result can be written.
void requireWritable(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  makeDirectories(folder.string());
  if (std::filesystem::is_directory(file) || access(folder.c_str(), W_OK) != 0) {
    throw InputError(file + ": cannot be written; give --output a file in a writable folder");
  }
}

void run(const FitOptions& options) {
  requireWritable(options.output);
  const Config config = configWithWarnings(options.config);
  std::vector<FloorPlan> plans;
  for (const std::string& file : floorPlanFiles(options.plans)) {
    plans.push_back(readFloorPlan(file));
  }
  const std::vector<TrainingCells> drives = Drives(options, plans, config).make();
  writeAtomically(options.output, describe(options, drives) + toYaml(fitBeliefModel(drives)));
}

}  // namespace

void runFit(Options& options) {
  FitOptions fit;
  options.addList("plan", "FILE", fit.plans,
                  "floor plans, or directories of them, for every second drive; the other drives "
                  "take generated buildings");
  options.addInRange("drives", fit.drives, 10, 100000, "drives of each driving style");
  options.addInRange("cells", fit.cells, 10, 1000000, "approximate number of cells of each drive");
  options.addInRange("seed", fit.seed, 0, 1000000, "seed of all random numbers");
  options.add("config", "FILE", fit.config, "settings as in config/mapping.yaml");
  options.addInRange("workers", fit.workers, 1, 256, "threads");
  options.addRequired("output", "FILE", fit.output, "file for the model (YAML)");
  if (options.parse()) {
    run(fit);
  }
}

}  // namespace sfw
