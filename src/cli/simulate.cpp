#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/plan_options.h"
#include "files/atomic_file.h"
#include "ros/bags/bag_writer.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"

namespace sfw {
namespace {

struct SimulateOptions {
  BuildingArgument building;
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
  options.scenario.level = parseNoiseLevel(options.noise);
  const FloorPlan plan = options.building.make(options.scenario.seed);
  const Scenario scenario = makeScenario(plan, accessPointsOf(options), options.scenario);
  const SimulatedRecording recording = simulate(scenario);
  makeDirectories(options.output);
  writePlanFiles(toStates(plan), options.output, "truth");
  writeAtomically(options.output + "/access_points.yaml", accessPointsYaml(scenario.access_points));
  if (options.bag) {
    writeBag(options.output + "/recording.bag", recording, Config().ros);
  }
  writeAtomically(options.output + "/readings.csv", readingsCsv(recording.readings));
  std::cerr << "sfw: wrote " << recording.readings.size()
            << " readings, access points and truth to " << options.output << '\n';
}

}  // namespace

void addSimulateCommand(CLI::App& sfw) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = sfw.add_subcommand(
      "simulate", "Drive a simulated robot through a known building and record what it hears.");
  addBuildingOptions(*command, options->building);
  command->add_option("--access-point", options->access_points,
                      "X,Y in the plan's frame [m]; may be repeated");
  command
      ->add_option("--access-points", options->scenario.access_points,
                   "how many to place, if none is given")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command->add_option("--noise", options->noise, "none, low, ideal, realistic or hard")
      ->capture_default_str();
  command->add_option("--path", options->scenario.path, "walls, sparse or a CSV of way points")
      ->capture_default_str();
  command->add_option("--robot-radius", options->scenario.robot_radius, "[m]")
      ->capture_default_str();
  command->add_option("--seed", options->scenario.seed, "decides all that is random")
      ->capture_default_str();
  command->add_flag("--bag", options->bag, "write recording.bag too");
  command
      ->add_option("--output", options->output,
                   "directory for readings.csv, access_points.yaml, truth.yaml and truth.pgm")
      ->required();
  command->callback([options] { run(*options); });
}

}  // namespace sfw
