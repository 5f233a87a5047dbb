#include "ros/simulator/simulator_world.h"

#include "simulation/building/building_source.h"
#include "simulation/radio/noise_level.h"
#include "simulation/scenario.h"

namespace sfw {
namespace {

std::vector<Position> wayPointsOf(const Grid<CellState>& plan, const SimulatorConfig& config) {
  RoutePlannerConfig planner;
  planner.robot_radius_m = config.robot.radius_m;
  if (!config.noise.empty()) {
    planner.clearance_m = wallClearance(noiseLevel(config.noise), config.signals.radio.seed);
  }
  // A robot under manual control needs only the start of the route, and a sparse route is short.
  const bool short_route = parseRouteKind(config.route) && config.drive != "route";
  return wayPoints(short_route ? "sparse" : config.route, plan, planner);
}

}  // namespace

SimulatorWorld makeSimulatorWorld(const SimulatorConfig& config) {
  SimulatorWorld world{
      makeFloorPlan(config.building, config.signals.radio.seed), config.access_points, {}};
  if (world.access_points.empty()) {
    world.access_points =
        placeAccessPoints(world.plan, config.access_point_count, config.signals.radio.seed);
  }
  world.way_points = wayPointsOf(toStates(world.plan), config);
  return world;
}

}  // namespace sfw
