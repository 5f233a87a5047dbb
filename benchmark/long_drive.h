#pragma once

#include <vector>

#include "office_floor.h"
#include "simulation/robot/route_planner.h"
#include "simulation/scenario.h"
#include "simulation/simulated_recording.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

constexpr double kMinute = 60.0;  // [s]

/// A drive of 200 minutes, which is 6 km, through the office floor with three access points. It
/// goes along the walls of all rooms, then on patrol, then along the walls at another clearance,
/// and so on: no two laps have the same positions.
inline Scenario longDrive() {
  constexpr double kLongest = 200.0 * kMinute;
  constexpr double kRobotRadius = 0.15;  // [m]
  ScenarioConfig config;
  config.access_points = 3;
  config.robot_radius_m = kRobotRadius;
  Scenario scenario = makeScenario(officeFloor(), {}, config);
  const Grid<CellState> states = toStates(scenario.plan);
  for (const double clearance : {0.3, 0.2, 0.4, 0.25, 0.35, 0.45, 0.22, 0.28, 0.32, 0.38}) {
    for (const RouteKind kind : {RouteKind::kSparse, RouteKind::kWalls}) {
      const RecordingConfig& recording = scenario.recording;
      if (Route(scenario.way_points, recording.speed_m_s, recording.yaw_rate_rad_s).duration() <
          kLongest) {
        const std::vector<Position> lap =
            planRoute(states, kind, {kRobotRadius, clearance, scenario.way_points.back()});
        scenario.way_points.insert(scenario.way_points.end(), lap.begin() + 1, lap.end());
      }
    }
  }
  return scenario;
}

/// The readings of a drive between two times.
/// @param from_s,to_s  since its start; the second one does not belong to the part
inline std::vector<Reading> readingsBetween(double from_s, double to_s, const Scenario& scenario,
                                            const std::vector<Reading>& readings) {
  std::vector<Reading> part;
  for (const Reading& reading : readings) {
    const double at_s = static_cast<double>(reading.stamp_ns) * 1e-9 - scenario.recording.start_s;
    if (at_s >= from_s && at_s < to_s) {
      part.push_back(reading);
    }
  }
  return part;
}

/// The mapper after the first minutes of a drive.
inline Mapper mapperAfter(double minutes, const Scenario& scenario,
                          const std::vector<Reading>& readings) {
  Mapper mapper(Config(), scenario.access_points);
  for (const Reading& reading : readingsBetween(0.0, minutes * kMinute, scenario, readings)) {
    mapper.insert(reading);
  }
  return mapper;
}

}  // namespace sfw
