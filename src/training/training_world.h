#pragma once

#include <vector>

#include "base/random.h"
#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Variations of buildings and ways, for training drives.

/// Cuts one to three rectangles of 1 to 5 m out of a building: walled off, unknown inside.
void cutOut(FloorPlan& plan, Random& random);

/// Stands boxes of 0.3 to 1.2 m depth against walls, one for each 3 to 9 m2.
void furnish(FloorPlan& plan, Random& random);

/// The way as a person would steer it: way points left out and displaced, corners cut.
/// @param clearance_m  kept from everything that is not free
std::vector<Position> withHumanSteering(const std::vector<Position>& way, const FloorPlan& plan,
                                        double clearance_m, Random& random);

/// The way with strolls of some ten steps around its way points, as on a survey.
/// @param clearance_m  kept from everything that is not free, on the strolls
std::vector<Position> withRandomWalks(const std::vector<Position>& way, const FloorPlan& plan,
                                      double clearance_m, Random& random);

}  // namespace sfw
