#pragma once

#include <vector>

#include "ros/simulator/simulator_config.h"
#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The building, the access points and the route of a simulation.
struct SimulatorWorld {
  FloorPlan plan;
  std::vector<AccessPoint> access_points;
  std::vector<Position> way_points;  ///< [m], map frame; by cmd_vel the robot starts at the first
                                     ///< and faces the second, and the others are not used
};

/// Reads or generates the building, reads or plans the route, and chooses sites for access points
/// unless they are given.
/// @param config  valid
/// @throw InputError naming the file or the setting, if there is no such file or building, or the
/// route or an access point does not fit it.
SimulatorWorld makeSimulatorWorld(const SimulatorConfig& config);

}  // namespace sfw
