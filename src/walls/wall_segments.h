#pragma once

#include <vector>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/wall_segment.h"
#include "walls/strip_walls.h"

namespace sfw {

/// Splits a wall into straight pieces along the axes of the building.
///
/// The cells of a piece lie in a band three cells wide. The piece runs along the band, through the
/// median of its cells, and ends at the edges of cells. A new piece begins where the wall leaves
/// the band, and behind a gap.
/// @param geometry  of the wall's cells
/// @return in the frame of the grid, not in that of a map; in the order of the cells
/// O(cells of the wall).
std::vector<WallSegment> straightPieces(const StripWall& wall, const GridGeometry& geometry);

}  // namespace sfw
