#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/old_name.h"
#include "cli/building_options.h"
#include "cli/commands.h"
#include "cli/warnings.h"
#include "files/atomic_file.h"
#include "files/map_server.h"
#include "ros/bags/bag_writer.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

constexpr std::int64_t kMostAccessPoints = 100;

struct SimulateOptions {
  BuildingSource building;
  std::vector<std::string> positions;
  std::string table;
  std::string noise = "realistic";
  ScenarioConfig scenario;
  bool bag = false;
  bool force = false;
  std::string output;
};

/// @throw InputError if a file of another recording would be overwritten
void requireNewRecording(const SimulateOptions& options) {
  for (const char* name :
       {"readings.csv", "access_points.yaml", "truth.yaml", "truth.pgm", "recording.bag"}) {
    const std::string file = options.output + "/" + name;
    if (!options.force && std::filesystem::exists(file)) {
      throw InputError(file +
                       " is there already, and may be somebody's recording; choose another "
                       "--output, or overwrite it with --force");
    }
  }
}

/// A number was once the value of --access-points.
void takeOldCount(SimulateOptions& options) {
  constexpr std::size_t kDigits = 9;
  if (options.table.empty() || options.table.size() > kDigits ||
      options.table.find_first_not_of("0123456789") != std::string::npos) {
    return;
  }
  warn("sfw simulate: " + oldNameWarning("--access-points with a number", "--access-point-count"));
  options.scenario.access_points = std::stoll(options.table);
  options.table.clear();
  if (options.scenario.access_points < 1 || options.scenario.access_points > kMostAccessPoints) {
    throw InputError("--access-point-count must be in 1..100");
  }
}

std::vector<AccessPoint> accessPointsOf(const SimulateOptions& options) {
  if (!options.table.empty()) {
    std::vector<AccessPoint> table = accessPointsWithWarnings(options.table);
    for (const AccessPoint& access_point : table) {
      if (!access_point.position_known) {
        throw InputError(options.table + ": " + access_point.bssid.str() +
                         " needs x and y: a simulation does not estimate them");
      }
    }
    return table;
  }
  std::vector<AccessPoint> access_points;
  for (std::size_t i = 0; i < options.positions.size(); ++i) {
    AccessPoint access_point;
    access_point.bssid = numberedBssid(i + 1);
    access_point.name = "access point " + std::to_string(i + 1);
    access_point.position = parsePosition("--access-point", options.positions[i]);
    access_points.push_back(access_point);
  }
  return access_points;
}

void run(SimulateOptions options) {
  takeOldCount(options);
  requireNewRecording(options);
  options.scenario.noise = noiseLevel(options.noise);
  if (const auto warning = oldNoiseLevelWarning(options.noise)) {
    warn(*warning);
  }
  const FloorPlan plan = makeFloorPlan(options.building, options.scenario.seed);
  const Scenario scenario = makeScenario(plan, accessPointsOf(options), options.scenario);
  const SimulatedRecording recording = simulate(scenario);
  makeDirectories(options.output);
  writeMap(toStates(plan), options.output, "truth");
  writeAtomically(options.output + "/access_points.yaml", accessPointsYaml(scenario.access_points));
  if (options.bag) {
    writeBag(options.output + "/recording.bag", recording, RosSettings());
  }
  writeAtomically(options.output + "/readings.csv", readingsCsv(recording.readings));
  std::cerr << "sfw: wrote " << recording.readings.size()
            << " readings, access points and truth to " << options.output << '\n';
}

}  // namespace

void runSimulate(Options& options) {
  SimulateOptions simulate;
  addBuildingOptions(options, simulate.building);
  options.addList("access-point", "X,Y", simulate.positions,
                  "position of an access point in the frame of the plan [m]");
  options.add("access-points", "FILE", simulate.table,
              "YAML: access_points: [{bssid, x, y, z?, name?, tx_dbm?}] in the frame of the plan");
  options.addInRange("access-point-count", simulate.scenario.access_points, 1, kMostAccessPoints,
                     "number of access points to place if neither --access-point nor "
                     "--access-points is given");
  options.add("noise", "LEVEL", simulate.noise, "noise level: " + noiseLevelHelp());
  options.add("path", "PATH", simulate.scenario.path, "walls, sparse or a CSV of way points");
  options.add("robot-radius", "METRES", simulate.scenario.robot_radius_m,
              "radius of the robot [m]");
  options.add("seed", "N", simulate.scenario.seed, "seed of everything random");
  options.addFlag("bag", simulate.bag, "also write recording.bag");
  options.addRequired("output", "DIRECTORY", simulate.output,
                      "directory for readings.csv, access_points.yaml, truth.yaml and truth.pgm");
  options.addFlag("force", simulate.force, "overwrite a recording in the output directory");
  if (!options.parse()) {
    return;
  }
  if (options.given("access-point") && options.given("access-points")) {
    throw InputError("--access-point and --access-points exclude each other");
  }
  run(simulate);
}

}  // namespace sfw
