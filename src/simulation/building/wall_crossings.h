#pragma once

#include <vector>

#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A wall that a line goes through.
struct WallCrossing {
  Position middle = Position::Zero();  ///< of the stretch inside the wall [m]
  Material material = Material::kInteriorWall;
};

/// The walls on the straight line between two points, in order, each once however thick it is.
///
/// A wall is a run of wall cells among those that Ray walks through; two wall cells that meet in a
/// corner leave no gap for a line through that very corner. These are the walls that
/// forwardKVisibility counts. Its material is that of most of the cells crossed. A wall in which an
/// end of the line lies does not stand between them and is left out; unknown cells and all outside
/// the plan are no wall. The same walls in both directions. The ends must lie within the range of
/// Ray. O(cells crossed).
std::vector<WallCrossing> wallsBetween(const FloorPlan& plan, const Position& from,
                                       const Position& to);

/// How many walls wallsBetween finds.
int countWalls(const FloorPlan& plan, const Position& from, const Position& to);
int countWalls(const Grid<CellState>& plan, const Position& from, const Position& to);

}  // namespace sfw
