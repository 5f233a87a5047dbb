#pragma once

#include <cstdint>
#include <vector>

#include "simulation/robot/route.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A laser scanner in the middle of a robot. It looks all around and measures without error.
struct LaserConfig {
  double rate_hz = 0.0;      ///< scans in simulated time [Hz], 0..1000; 0: there is no scanner
  std::int64_t beams = 360;  ///< 1..10000, the first one backwards, then counter-clockwise
  double range_m = 8.0;      ///< it sees no farther [m], 0.1..100
};

/// Distance [m] of the nearest obstacle on each beam, infinity beyond the range.
///
/// Obstacles are the cells that stop a SimulatedRobot: all that are not free, and all beyond the
/// plan. O(beams x cells crossed).
/// @param pose  map frame, in a free cell
std::vector<double> laserRanges(const Grid<CellState>& plan, const RobotPose& pose,
                                const LaserConfig& config);

/// Bearing [rad] of a beam from the robot's front, in [-pi, pi).
double beamBearing(const LaserConfig& config, std::int64_t beam);

}  // namespace sfw
