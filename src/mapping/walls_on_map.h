#pragma once

#include <vector>

#include "grid/mask.h"
#include "path/building_frame.h"
#include "walls/strip_walls.h"

namespace sfw {

/// The cells of walls on the grid of a map, as lines of one cell. A wall ends before the way of the
/// robot, so that planners which keep a distance from walls find the doors wide enough. Outer walls
/// are not among them: early in a drive the network expects some where the robot has not been yet,
/// and these would shut it in.
/// @param building  grid of the walls' cells, building frame
/// @param open      cells on the map that no wall may take
Mask wallsOnMap(const std::vector<StripWall>& found, const GridGeometry& building,
                const BuildingFrame& frame, const Mask& open);

}  // namespace sfw
