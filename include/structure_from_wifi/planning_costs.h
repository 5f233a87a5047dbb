#pragma once

#include <cstdint>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

constexpr std::int8_t kUnknownCost = -1;    ///< of a cell that the map does not know
constexpr std::int8_t kDearestCost = 99;    ///< of a free cell
constexpr std::int8_t kOccupiedCost = 100;  ///< of a wall or contact

/// What it costs to move the centre of the robot through each cell, for global planners.
///
/// The map alone says too little: where it misses a wall, or draws it beside its place, a short
/// way through cells that are probably free looks as good as the way that the robot knows.
/// So a free cell costs the more, the likelier the robot touches something there. Its risk is the
/// highest probability of being occupied within `footprint_radius_m` and 15 cm. The cost grows
/// linearly with the risk and is kDearestCost from a risk of 1/4 on.
///
/// What the robot touches is seldom a single cell. So each contact stands for a wall of 0.4 m
/// across the direction of the touch, except where the robot was.
/// @param snapshot            a map
/// @param footprint_radius_m  of the robot
/// @return costs from 0 to 100, or kUnknownCost, on the cells of the map
SFW_EXPORT Grid<std::int8_t> planningCosts(const Snapshot& snapshot, double footprint_radius_m);

}  // namespace sfw
