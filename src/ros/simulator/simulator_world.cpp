#include "ros/simulator/simulator_world.h"

#include "simulation/building/floor_plan_io.h"
#include "simulation/building/plan_generator.h"
#include "simulation/radio/noise_level.h"
#include "simulation/robot/route_planner.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

FloorPlan planOf(const SimulatorConfig& config) {
  if (!config.plan.empty()) {
    PlanOptions options;
    options.resolution_m = config.resolution_m;
    if (config.metres_per_pixel != 0.0) {
      options.metres_per_pixel = config.metres_per_pixel;
    }
    return readFloorPlan(config.plan, options);
  }
  PlanGeneratorConfig building;
  building.kind = parseBuildingKind(config.generate);
  building.area_m2 = config.area_m2;
  building.resolution_m = config.resolution_m;
  building.seed = static_cast<std::uint64_t>(config.signals.radio.seed);
  return generatePlan(building).plan;
}

std::vector<Position> readRoute(const Grid<CellState>& plan, const SimulatorConfig& config) {
  std::vector<Position> way_points = readWayPoints(config.route);
  try {
    requireFree(plan, way_points, config.robot.radius_m);
  } catch (const InputError& error) {
    throw InputError(config.route + ": " + error.what());
  }
  return way_points;
}

std::vector<Position> planRoute(const Grid<CellState>& plan, const SimulatorConfig& config) {
  RoutePlannerConfig planner;
  planner.robot_radius_m = config.robot.radius_m;
  if (!config.noise.empty()) {
    planner.clearance_m = wallClearance(noiseLevel(config.noise), config.signals.radio.seed);
  }
  // Only the start of the route matters to a robot that is driven by hand, and this one is short.
  const bool along_walls = config.route == "walls" && config.drive == "route";
  try {
    return sfw::planRoute(plan, along_walls ? RouteKind::kWalls : RouteKind::kSparse, planner);
  } catch (const InputError& error) {
    throw InputError("route " + config.route + ": " + error.what());
  }
}

}  // namespace

SimulatorWorld makeSimulatorWorld(const SimulatorConfig& config) {
  SimulatorWorld world{planOf(config), config.access_points, {}};
  if (world.access_points.empty()) {
    world.access_points =
        placeAccessPoints(world.plan, config.access_point_count, config.signals.radio.seed);
  }
  const Grid<CellState> states = toStates(world.plan);
  const bool planned = config.route == "walls" || config.route == "sparse";
  world.way_points = planned ? planRoute(states, config) : readRoute(states, config);
  return world;
}

}  // namespace sfw
