#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "evaluation/exploration_run.h"
#include "simulation/building/floor_plan.h"

namespace sfw {

/// The names of the policies that an exploration is compared with, and its own, "explorer".
std::vector<std::string> explorationPolicyNames();

/// Makes a policy.
///
/// - explorer: Pilot, this package's exploration.
/// - nearest_frontier: drives to frontiers of the map as explore_lite 2.1 does with its default
///   settings; the drives are those of WayDriver.
/// - random_walk: straight ahead; after a touch it turns by 90 to 270 degrees.
/// - wall_following: feels its way along walls on its right by touching them again and again.
/// - lawnmower: straight lanes, one beside the other; touches end a lane.
/// - walls: a route along all walls that was planned on the true plan, as a person might drive.
///
/// @param plan,start  for "walls" alone
/// @throw InputError if there is no such policy
std::unique_ptr<ExplorationPolicy> makeExplorationPolicy(const std::string& name,
                                                         const FloorPlan& plan,
                                                         const Position& start, std::int64_t seed);

}  // namespace sfw
