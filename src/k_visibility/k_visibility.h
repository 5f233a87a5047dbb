#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Values of a k map beside the counts 0..kMostWalls, as k.pgm holds them.
constexpr std::uint8_t kMostWalls = 250;  ///< largest count; more walls count as this
constexpr std::uint8_t kNoCount = 254;    ///< outside the building, or not known
constexpr std::uint8_t kWallCell = 255;

/// Counts the walls between an access point and the centre of each free cell (k-visibility).
///
/// k is the number of runs of occupied cells on the ray (ray.h), so a wall of any thickness counts
/// once. countWalls finds the same number, and a simulated recording contains it as its true k.
/// Unknown cells are not walls and get kNoCount. Occupied cells get kWallCell. If the access point
/// lies inside a wall, that wall is not counted. A wall at an angle to the grid is a staircase. A
/// ray nearly parallel to it may leave it between two steps and count it again
/// (doc/method/k_visibility.md).
///
/// One sweep over the grid carries the count from row to row in each of four cones. The count is a
/// piecewise constant function of the ray's slope, in exact integers (ConeSweep).
/// O(cells + pieces of each row); the number of pieces is about that of visible wall ends.
///
/// @param access_point  [m], finite; it may lie outside the grid
/// @throw InputError if the access point lies more than 2^19 cells away.
Grid<std::uint8_t> forwardKVisibility(const Grid<CellState>& plan, const Position& access_point);

/// Dense inverse k-visibility: recovers the walls from a full k map, by the paper's section III.
///
/// Rays run from the access point to the rim of the grid and to each counted cell beside one
/// without a count. If consecutive counts follow each other on a ray, the kWallCell cells between
/// them become occupied. In a map without kWallCell, all cells without a count between them become
/// occupied. Cells with a count become free; all others stay unknown. Each wall with counted cells
/// on both sides is recovered exactly from forwardKVisibility. O(cells + counted cells beside walls
/// x cells of a ray).
/// @param access_point  [m], finite
Grid<CellState> denseInverseKVisibility(const Grid<std::uint8_t>& k_map,
                                        const Position& access_point);

}  // namespace sfw
