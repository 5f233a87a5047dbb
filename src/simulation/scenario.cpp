#include "simulation/scenario.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>

#include "base/random.h"
#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/readings_io.h"

namespace sfw {
namespace {

constexpr std::uint64_t kPlacementStream = 0x706c616365;  // none of random_streams.h

/// The centres of the free cells that are at least a distance from every other kind of cell.
std::vector<Position> roomyPlaces(const FloorPlan& plan, double distance_m) {
  const GridGeometry& geometry = plan.geometry;
  Mask obstacles(geometry, 0);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    obstacles.cells[i] = plan.cells[i] == Material::kFree ? 0 : 1;
  }
  const Grid<double> cells_away = distanceTransform(obstacles);
  std::vector<Position> places;
  forEachCell(geometry, [&](Cell c) {
    if (cells_away[c] * geometry.resolution() >= distance_m) {
      places.push_back(geometry.centre(c));
    }
  });
  return places;
}

double distanceToNearest(const Position& place, const std::vector<AccessPoint>& others) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const AccessPoint& other : others) {
    nearest = std::min(nearest, (place - other.position).norm());
  }
  return nearest;
}

AccessPoint accessPoint(std::int64_t index, const Position& position) {
  AccessPoint access_point;
  access_point.bssid = numberedBssid(static_cast<std::size_t>(index) + 1);
  access_point.name = "access point " + std::to_string(index + 1);
  access_point.position = position;
  return access_point;
}

}  // namespace

Bssid numberedBssid(std::size_t number) {
  char text[18];
  std::snprintf(text, sizeof text, "02:00:00:00:%02x:%02x",
                static_cast<unsigned>(number >> 8 & 0xff), static_cast<unsigned>(number & 0xff));
  return *Bssid::parse(text);
}

std::vector<AccessPoint> placeAccessPoints(const FloorPlan& plan, std::int64_t count,
                                           std::int64_t seed) {
  constexpr double kFromWalls = 0.3;  // [m]
  constexpr int kCandidates = 20;     // for each: enough to spread, too few to fill the walls
  const std::vector<Position> places = roomyPlaces(plan, kFromWalls);
  if (places.empty()) {
    throw InputError(
        "the plan has no free site for an access point 0.3 m from walls; use a larger plan or give "
        "the positions of access points");
  }
  std::vector<AccessPoint> access_points;
  for (std::int64_t i = 0; i < count; ++i) {
    Random random(seed, kPlacementStream, static_cast<std::uint64_t>(i));
    Position best = places.front();
    double best_distance = -1.0;
    for (int candidate = 0; candidate < (i == 0 ? 1 : kCandidates); ++candidate) {
      const auto index =
          static_cast<std::size_t>((1.0 - random.uniform()) * static_cast<double>(places.size()));
      const double distance = distanceToNearest(places[index], access_points);
      if (distance > best_distance) {
        best_distance = distance;
        best = places[index];
      }
    }
    access_points.push_back(accessPoint(i, best));
  }
  return access_points;
}

std::vector<Position> wayPoints(const std::string& route, const Grid<CellState>& plan,
                                const RoutePlannerConfig& config) {
  const std::optional<RouteKind> kind = parseRouteKind(route);
  if (kind) {
    try {
      return planRoute(plan, *kind, config);
    } catch (const InputError& error) {
      throw InputError("route " + route + ": " + error.what());
    }
  }
  std::vector<Position> way_points = readWayPoints(route);
  try {
    requireFree(plan, way_points, config.robot_radius_m);
  } catch (const InputError& error) {
    throw InputError(route + ": " + error.what());
  }
  return way_points;
}

Scenario makeScenario(const FloorPlan& plan, const std::vector<AccessPoint>& access_points,
                      const ScenarioConfig& config) {
  RoutePlannerConfig planner;
  planner.robot_radius_m = config.robot_radius_m;
  planner.clearance_m = wallClearance(config.noise, config.seed);
  return {plan,
          access_points.empty() ? placeAccessPoints(plan, config.access_points, config.seed)
                                : access_points,
          wayPoints(config.path, toStates(plan), planner),
          recordingConfig(config.noise, config.seed)};
}

SimulatedRecording simulate(const Scenario& scenario) {
  return simulateRecording(scenario.plan, scenario.way_points,
                           asTransmitters(scenario.access_points), scenario.recording);
}

}  // namespace sfw
