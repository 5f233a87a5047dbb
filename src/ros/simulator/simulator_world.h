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
  std::vector<Position> way_points;  ///< [m], map frame; a robot driven by cmd_vel starts at the
                                     ///< first, looking at the second, and leaves out the others
};

/// Reads or makes the building; reads or plans the route; places access points unless they are
/// given.
/// @param config  valid
/// @throw InputError naming the file or the setting, if there is no such file or building, or the
/// route or an access point does not fit it.
SimulatorWorld makeSimulatorWorld(const SimulatorConfig& config);

}  // namespace sfw
