#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

// Buildings for training drives, and random variations of buildings and routes.

/// Generates a building of 35 to 135 m2: one in four is an office, and every second one is rotated.
/// Deterministic.
FloorPlan makeTrainingBuilding(std::int64_t seed);

/// Generates a building for a survey, of 60 to 260 m2: four in five are offices. Deterministic.
FloorPlan makeSurveyBuilding(std::int64_t seed);

/// Cuts one to three rectangles of 1 to 5 m out of a building: with walls around, unknown inside.
void cutOut(FloorPlan& plan, Random& random);

/// Places boxes of 0.3 to 1.2 m depth along walls, one for each 3 to 9 m2.
void furnish(FloorPlan& plan, Random& random);

/// Changes a route as a person would steer it: way points are left out or displaced, and corners
/// are cut.
/// @param clearance_m  to everything that is not free
std::vector<Position> withHumanSteering(const std::vector<Position>& route, const FloorPlan& plan,
                                        double clearance_m, Random& random);

/// Adds random walks of about ten steps around the way points of a route, as on a survey.
/// @param clearance_m  of the walks to everything that is not free
std::vector<Position> withRandomWalks(const std::vector<Position>& route, const FloorPlan& plan,
                                      double clearance_m, Random& random);

}  // namespace sfw
