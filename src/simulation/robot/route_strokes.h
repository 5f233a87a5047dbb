#pragma once

#include <cstdint>
#include <vector>

#include "simulation/robot/configuration_space.h"

namespace sfw {

/// A part of a route that is driven in one go.
struct Stroke {
  std::vector<Cell> cells;  ///< in order of driving; at least one
  bool closed = false;      ///< it may start at any of its cells and ends there; else at either end
  std::int64_t room = 0;    ///< strokes of one room are driven together; 0 is no room
};

/// All that a drive along the walls consists of: loops at `distance` [cells] from the walls, lines
/// across the rooms, and single places in narrow corners.
std::vector<Stroke> wallStrokes(const ConfigurationSpace& space, double distance);

/// The places of a patrol. Rooms are divided where they are narrower than twice `distance` [cells],
/// and at doors in any case.
std::vector<Stroke> patrolStrokes(const ConfigurationSpace& space, double distance);

}  // namespace sfw
