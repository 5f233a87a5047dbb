#include <iostream>
#include <memory>
#include <string>
#include <vector>

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

struct SimulateOptions {
  BuildingSource building;
  std::vector<std::string> access_points;
  std::string noise = "realistic";
  ScenarioConfig scenario;
  bool bag = false;
  std::string output;
};

std::vector<AccessPoint> accessPointsOf(const SimulateOptions& options) {
  std::vector<AccessPoint> access_points;
  for (std::size_t i = 0; i < options.access_points.size(); ++i) {
    AccessPoint access_point;
    access_point.bssid = numberedBssid(i + 1);
    access_point.name = "access point " + std::to_string(i + 1);
    access_point.position = parsePosition("--access-point", options.access_points[i]);
    access_points.push_back(access_point);
  }
  return access_points;
}

void run(SimulateOptions options) {
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
  options.addList("access-point", "X,Y", simulate.access_points,
                  "position of an access point in the frame of the plan [m]");
  options.addInRange("access-points", simulate.scenario.access_points, 1, 100,
                     "number of access points to place if no --access-point is given");
  options.add("noise", "LEVEL", simulate.noise, "noise level: " + noiseLevelHelp());
  options.add("path", "PATH", simulate.scenario.path, "walls, sparse or a CSV of way points");
  options.add("robot-radius", "METRES", simulate.scenario.robot_radius_m,
              "radius of the robot [m]");
  options.add("seed", "N", simulate.scenario.seed, "seed of everything random");
  options.addFlag("bag", simulate.bag, "also write recording.bag");
  options.addRequired("output", "DIRECTORY", simulate.output,
                      "directory for readings.csv, access_points.yaml, truth.yaml and truth.pgm");
  if (options.parse()) {
    run(simulate);
  }
}

}  // namespace sfw
