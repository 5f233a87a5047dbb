#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "simulation/building/floor_plan.h"
#include "simulation/radio/noise_level.h"
#include "simulation/robot/route_planner.h"
#include "simulation/simulated_recording.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A drive through a known building, still to be simulated.
struct Scenario {
  FloorPlan plan;
  std::vector<AccessPoint> access_points;
  std::vector<Position> way_points;  ///< [m], map frame
  RecordingConfig recording;
};

/// What to make of a plan.
struct ScenarioConfig {
  NoiseLevel noise = noiseLevel("realistic");
  std::string path = "walls";      ///< "walls", "sparse" or a CSV file of way points
  double robot_radius_m = 0.15;    ///< [m]
  std::int64_t seed = 1;           ///< decides all that is random
  std::int64_t access_points = 1;  ///< how many to place, if none are given
};

/// A locally administered address, 02:00:00:00:00:01 for 1.
Bssid numberedBssid(std::size_t number);

/// Places for access points: free, 0.3 m or more from walls, and far from each other.
/// @throw InputError if the plan has no such place.
/// Deterministic; O(cells).
std::vector<AccessPoint> placeAccessPoints(const FloorPlan& plan, std::int64_t count,
                                           std::int64_t seed);

/// Way points [m] of a route by its name: planned, or read from a file.
/// @param route  "walls", "sparse" or a CSV file of way points
/// @throw InputError that names the route, if it cannot be planned or read, or hits an obstacle.
std::vector<Position> wayPoints(const std::string& route, const Grid<CellState>& plan,
                                const RoutePlannerConfig& config);

/// Chooses access points (unless `access_points` names them), path and noise.
/// @throw InputError if the path or an access point does not fit the plan.
Scenario makeScenario(const FloorPlan& plan, const std::vector<AccessPoint>& access_points,
                      const ScenarioConfig& config);

/// Drives it.
SimulatedRecording simulate(const Scenario& scenario);

}  // namespace sfw
