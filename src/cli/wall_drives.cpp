#include <algorithm>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "cli/commands.h"
#include "cli/floor_plan_files.h"
#include "cli/parallel_for.h"
#include "cli/progress.h"
#include "cli/warnings.h"
#include "files/atomic_file.h"
#include "files/npy.h"
#include "simulation/building/floor_plan_io.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/version.h"
#include "training/training_world.h"
#include "training/wall_drive.h"
#include "walls/network_inputs.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

struct WallDriveOptions {
  std::vector<std::string> plans;
  std::vector<std::string> excluded;
  std::int64_t drives = 1200;
  std::int64_t seed = 1;
  std::string config;
  std::int64_t workers = std::max(1U, std::thread::hardware_concurrency());
  std::string output;
};

struct NamedPlan {
  std::string name;
  FloorPlan plan;
};

/// The first part of the name of a plan's file: what comes before the first '.' or '_'.
std::string identityOf(const std::string& file) {
  const std::string name = fs::path(file).filename().string();
  return name.substr(0, name.find_first_of("._"));
}

/// Plans without those that tests use. Copies of one plan have names that begin alike.
/// @throw InputError if a plan to exclude does not exist: its name may be misspelt.
std::vector<std::string> allowedPlans(const WallDriveOptions& options) {
  std::vector<std::string> excluded;
  for (const std::string& file : floorPlanFiles(options.excluded)) {
    if (!fs::exists(file)) {
      throw InputError(file +
                       ": does not exist; give --exclude floor plans or directories of them");
    }
    excluded.push_back(identityOf(file));
  }
  std::vector<std::string> allowed;
  for (const std::string& file : floorPlanFiles(options.plans)) {
    if (std::find(excluded.begin(), excluded.end(), identityOf(file)) == excluded.end()) {
      allowed.push_back(file);
    }
  }
  return allowed;
}

/// Reads the plans. Drives through very large ones would take most of the time.
std::vector<NamedPlan> readPlans(const std::vector<std::string>& files) {
  constexpr double kLargest = 30.0;  // [m]
  std::vector<NamedPlan> plans;
  for (const std::string& file : files) {
    FloorPlan plan = readFloorPlan(file);
    if (plan.geometry.box().sizes().maxCoeff() <= kLargest) {
      plans.push_back({fs::path(file).filename().string(), std::move(plan)});
    }
  }
  std::cerr << "sfw: uses " << plans.size() << " floor plans; " << files.size() - plans.size()
            << " are larger than " << kLargest << " m\n";
  return plans;
}

/// Takes the given plans in turn for most drives and generates the other buildings.
NamedPlan buildingFor(std::size_t drive, WallDriveKind kind, std::int64_t seed,
                      const std::vector<NamedPlan>& plans) {
  constexpr std::size_t kGenerated = 3;  // one building in so many
  if (!plans.empty() && drive % kGenerated != 0) {
    return plans[(drive - drive / kGenerated - 1) % plans.size()];
  }
  return {"generated",
          kind == WallDriveKind::kSurvey ? makeSurveyBuilding(seed) : makeTrainingBuilding(seed)};
}

std::string fileOf(std::size_t drive) {
  const std::string number = std::to_string(drive);
  return std::string(6 - std::min<std::size_t>(6, number.size()), '0') + number + ".npy";
}

/// Simulates one drive and writes its rasters.
/// @return its entry of drives.json; null if the drive does not fit into its building
nlohmann::json writeDrive(std::size_t drive, const WallDriveOptions& options,
                          const std::vector<NamedPlan>& plans, const Config& config) {
  // No two drives share a seed, and none shares it with a drive of `sfw fit`.
  constexpr std::int64_t kFirst = 10000000000000;
  constexpr std::int64_t kSeeds = 1000000;
  const std::int64_t seed = kFirst + options.seed * kSeeds + static_cast<std::int64_t>(drive);
  const WallDriveKind kind = chooseWallDriveKind(seed);
  const NamedPlan building = buildingFor(drive, kind, seed, plans);
  const std::optional<WallDrive> made = makeWallDrive(building.plan, kind, seed);
  if (!made) {
    return nullptr;
  }
  const Channels rasters = wallRasters(*made, config);
  writeAtomically(options.output + '/' + fileOf(drive),
                  npyOf({rasters.count(), rasters.height(), rasters.width()}, rasters.values()));
  return {{"file", fileOf(drive)},
          {"plan", building.name},
          {"kind", nameOf(made->kind)},
          {"noise", made->noise},
          {"seed", seed},
          {"access_points", made->drive.access_points.size()}};
}

nlohmann::json makeDrives(const WallDriveOptions& options, const std::vector<NamedPlan>& plans,
                          const Config& config) {
  std::vector<nlohmann::json> made(static_cast<std::size_t>(options.drives));
  std::mutex mutex;  // of the progress
  Progress progress(made.size());
  parallelFor(made.size(), options.workers, [&](std::size_t drive) {
    made[drive] = writeDrive(drive, options, plans, config);
    const std::lock_guard<std::mutex> lock(mutex);
    progress.add();
  });
  nlohmann::json drives = nlohmann::json::array();
  std::copy_if(made.begin(), made.end(), std::back_inserter(drives),
               [](const nlohmann::json& drive) { return !drive.is_null(); });
  return drives;
}

std::string commandOf(const WallDriveOptions& options) {
  return "sfw wall-drives --drives " + std::to_string(options.drives) + " --seed " +
         std::to_string(options.seed) + (options.plans.empty() ? "" : " --plan PLANS") +
         (options.excluded.empty() ? "" : " --exclude EXCLUDED");
}

void run(const WallDriveOptions& options) {
  const Config config = configWithWarnings(options.config);
  const std::vector<NamedPlan> plans = readPlans(allowedPlans(options));
  makeDirectories(options.output);
  const nlohmann::json drives = makeDrives(options, plans, config);
  const nlohmann::json index{
      {"command", commandOf(options)}, {"version", version()},
      {"plans", plans.size()},         {"cell_m", kNetworkCellM},
      {"inputs", networkInputNames()}, {"radio_inputs", networkRadioInputNames()},
      {"labels", wallLabelNames()},    {"drives", drives}};
  writeAtomically(options.output + "/drives.json", index.dump(1) + '\n');
  std::cerr << "sfw: wrote " << drives.size() << " of " << options.drives << " drives to "
            << options.output << "; the others do not fit into their buildings\n";
}

}  // namespace

void runWallDrives(Options& options) {
  WallDriveOptions drives;
  options.addList("plan", "FILE", drives.plans,
                  "floor plans, or directories of them, for two drives in three; the other drives "
                  "take generated buildings");
  options.addList(
      "exclude", "FILE", drives.excluded,
      "plans that tests use, or directories of them: no plan whose name begins alike is "
      "used");
  options.addInRange("drives", drives.drives, 1, 100000, "number of drives");
  options.addInRange("seed", drives.seed, 0, 1000000, "seed of all random numbers");
  options.add("config", "FILE", drives.config, "settings as in config/mapping.yaml");
  options.addInRange("workers", drives.workers, 1, 256, "threads");
  options.addRequired("output", "DIRECTORY", drives.output,
                      "directory for the rasters (NumPy files) and drives.json");
  if (options.parse()) {
    run(drives);
  }
}

}  // namespace sfw
