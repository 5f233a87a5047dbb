#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/building_options.h"
#include "cli/commands.h"
#include "cli/warnings.h"
#include "evaluation/exploration_peers.h"
#include "evaluation/exploration_run.h"
#include "evaluation/exploration_score.h"
#include "files/atomic_file.h"
#include "files/text.h"
#include "simulation/robot/configuration_space.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/map_files.h"

namespace sfw {
namespace {

struct ExploreOptions {
  BuildingSource building;
  std::string policy = "explorer";
  std::string noise = "realistic";
  std::string start;
  std::int64_t seed = 1;
  std::int64_t access_points = 2;
  std::int64_t minutes = 20;
  std::string output;
};

RobotPose startOf(const ExploreOptions& options, const FloorPlan& plan) {
  if (!options.start.empty()) {
    return {parsePosition("--start", options.start), 0.0};
  }
  const Grid<CellState> states = toStates(plan);
  const ConfigurationSpace space(states, 0.2);
  const std::optional<Cell> middle = space.middle();
  if (!middle) {
    throw InputError("the robot fits nowhere in the plan");
  }
  return {states.geometry.centre(*middle), 0.0};
}

std::string rowOf(const ExplorationReport& report, const ExplorationScore& score) {
  const auto& walls = score.all.walls;
  const auto& routes = score.all.routes;
  const auto& own = score.own.walls;
  return formatted("%.0f,%.0f,%zu,%s,%.1f,%.1f,%.1f,%.3f,%.3f,%.3f,%.3f,%.3f", report.time_s,
                   report.driven_m, report.touches,
                   report.stuck      ? "stuck"
                   : report.finished ? "finished"
                                     : "driving",
                   score.known_m2, score.wrong_m2, score.truth_m2,
                   walls && walls->f1 ? *walls->f1 : 0.0, routes ? routes->through_walls : 0.0,
                   routes ? routes->reached : 0.0, own && own->f1 ? *own->f1 : 0.0,
                   score.own.routes ? score.own.routes->through_walls : 0.0);
}

void run(const ExploreOptions& options) {
  const FloorPlan plan = makeFloorPlan(options.building, options.seed);
  const RobotPose start = startOf(options, plan);
  ExplorationRunConfig config;
  config.noise = noiseLevel(options.noise);
  if (const auto warning = oldNoiseLevelWarning(options.noise)) {
    warn(*warning);
  }
  config.seed = options.seed;
  config.report_s = {60.0 * static_cast<double>(options.minutes)};
  for (const std::int64_t minutes : {10, 5}) {
    if (minutes < options.minutes) {
      config.report_s.insert(config.report_s.begin(), 60.0 * static_cast<double>(minutes));
    }
  }
  config.access_points = placeAccessPoints(plan, options.access_points, options.seed);
  const auto policy = makeExplorationPolicy(options.policy, plan, start.position, options.seed);
  const std::vector<ExplorationReport> reports = runExploration(plan, start, *policy, config);
  const ExplorationScorer scorer(plan, start.position);
  std::string rows =
      "time_s,driven_m,touches,state,known_m2,wrong_m2,truth_m2,walls_f1,through_walls,reached,own_"
      "f1,own_through\n";
  for (const ExplorationReport& report : reports) {
    rows += rowOf(report, scorer.scoreOf(*report.map)) + "\n";
  }
  std::cout << rows;
  if (!options.output.empty()) {
    writeMapFiles(*reports.back().map, Config(), options.output);
    writeAtomically(options.output + "/exploration.csv", rows);
  }
}

}  // namespace

void runExplore(Options& options) {
  ExploreOptions explore;
  addBuildingOptions(options, explore.building);
  options.add("policy", "NAME", explore.policy,
              "explorer, nearest_frontier, random_walk, wall_following, lawnmower or walls");
  options.add("noise", "LEVEL", explore.noise, "noise level: " + noiseLevelHelp());
  options.add("start", "X,Y", explore.start,
              "start of the robot [m]; by default the middle of the widest place");
  options.add("seed", "N", explore.seed, "seed of everything random");
  options.addInRange("access-point-count", explore.access_points, 1, 100,
                     "number of access points to place");
  options.addInRange("minutes", explore.minutes, 1, 1000,
                     "length of the exploration; after 5 and 10 minutes are reports too");
  options.add("output", "DIRECTORY", explore.output, "directory for the files of the last map");
  if (!options.parse()) {
    return;
  }
  run(explore);
}

}  // namespace sfw
