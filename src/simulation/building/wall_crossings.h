#pragma once

#include <vector>

#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A wall that a line crosses.
struct WallCrossing {
  Position middle = Position::Zero();  ///< of the crossing, inside the wall [m]
  Material material = Material::kInteriorWall;
};

/// The walls on the straight line between two points, in order. Each wall appears once, whatever
/// its thickness.
///
/// A wall is a run of wall cells among the cells that Ray crosses. Two wall cells that meet in a
/// corner leave no gap for a line through that corner. forwardKVisibility counts the same walls.
/// The material of a wall is that of most of its crossed cells. A wall that contains an end of the
/// line does not count. Unknown cells and everything outside the plan are not walls. The walls are
/// the same in both directions. The ends must lie within the range of Ray. O(cells crossed).
std::vector<WallCrossing> wallsBetween(const FloorPlan& plan, const Position& from,
                                       const Position& to);

/// The number of walls that wallsBetween finds.
int countWalls(const FloorPlan& plan, const Position& from, const Position& to);
int countWalls(const Grid<CellState>& plan, const Position& from, const Position& to);

}  // namespace sfw
