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

/// A drive through a known building, before its simulation.
struct Scenario {
  FloorPlan plan;
  std::vector<AccessPoint> access_points;
  std::vector<Position> way_points;  ///< [m], map frame
  RecordingConfig recording;
};

/// The settings of a drive through a floor plan.
struct ScenarioConfig {
  NoiseLevel noise = noiseLevel("realistic");
  std::string path = "walls";      ///< "walls", "sparse" or a CSV file of way points
  double robot_radius_m = 0.15;    ///< [m]
  std::int64_t seed = 1;           ///< of all random numbers
  std::int64_t access_points = 1;  ///< number to choose if none are given
};

/// A locally administered BSSID: 02:00:00:00:00:01 for 1.
Bssid numberedBssid(std::size_t number);

/// Chooses sites for access points: free, at least 0.3 m from walls, and far from each other.
/// @throw InputError if the plan has no such site.
/// Deterministic; O(cells).
std::vector<AccessPoint> placeAccessPoints(const FloorPlan& plan, std::int64_t count,
                                           std::int64_t seed);

/// Way points [m] of a route by its name: planned, or read from a file.
/// @param route  "walls", "sparse" or a CSV file of way points
/// @throw InputError that names the route, if it cannot be planned or read, or hits an obstacle.
std::vector<Position> wayPoints(const std::string& route, const Grid<CellState>& plan,
                                const RoutePlannerConfig& config);

/// Chooses access points (unless `access_points` has some), plans the route and sets the noise.
/// @throw InputError if the path or an access point does not fit the plan.
Scenario makeScenario(const FloorPlan& plan, const std::vector<AccessPoint>& access_points,
                      const ScenarioConfig& config);

/// Simulates the drive of a scenario.
SimulatedRecording simulate(const Scenario& scenario);

}  // namespace sfw
