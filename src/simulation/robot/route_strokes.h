#pragma once

#include <cstdint>
#include <vector>

#include "simulation/robot/configuration_space.h"

namespace sfw {

/// A part of a route that is driven without interruption.
struct Stroke {
  std::vector<Cell> cells;  ///< in order of driving; at least one
  bool closed =
      false;  ///< starts and ends at any one of its cells; otherwise it starts at either end
  std::int64_t room = 0;  ///< strokes of one room are driven together; 0: no room
};

/// The strokes of a drive along the walls: loops at `distance` [cells] from the walls, lines across
/// the rooms, and single places in narrow corners.
std::vector<Stroke> wallStrokes(const ConfigurationSpace& space, double distance);

/// The strokes of a patrol, one place each. Rooms are divided where they are narrower than twice
/// `distance` [cells], and at every door.
std::vector<Stroke> patrolStrokes(const ConfigurationSpace& space, double distance);

}  // namespace sfw
