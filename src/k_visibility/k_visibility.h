#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Values of a k map beside the counts 0..kMostWalls, as k.pgm holds them.
constexpr std::uint8_t kMostWalls = 250;  ///< higher counts stay here
constexpr std::uint8_t kNoCount = 254;    ///< outside the building, or not known
constexpr std::uint8_t kWallCell = 255;

/// k-visibility: walls between an access point and the centre of each free cell.
///
/// A wall counts once however many cells thick it is: k is the number of runs of wall cells on the
/// ray (ray.h) between the two, exactly what countWalls finds there, and so what a simulated
/// recording holds for true k. Unknown cells are no wall and get kNoCount, occupied ones kWallCell.
/// An access point inside a wall hears through that wall for nothing. A wall that slants against
/// the grid is a staircase: a ray that rises or falls as the wall does may leave it between two
/// steps and count it again, others count it once (doc/method/k_visibility.md).
///
/// One sweep over the grid: in each of four cones it carries, from row to row away from the access
/// point, the count as a piecewise constant function of the ray's slope, in whole numbers.
/// O(cells + pieces of each row), and pieces are about the visible wall ends.
///
/// @param access_point [m], finite; it may lie outside the grid
/// @throw InputError if the access point lies more than 2^19 cells away.
Grid<std::uint8_t> forwardKVisibility(const Grid<CellState>& plan, const Position& access_point);

/// Dense inverse k-visibility: walls from a full k map, by the paper's section III.
///
/// Along rays from the access point to all around the grid, walls are what lies between regions of
/// consecutive counts: the kWallCell cells there, or, in a map that marks no walls, all cells
/// without a count. Cells with a count are free, all others unknown. The inverse of
/// forwardKVisibility on each wall that has counted cells on both sides. O(cells).
Grid<CellState> denseInverseKVisibility(const Grid<std::uint8_t>& k_map,
                                        const Position& access_point);

}  // namespace sfw
