#pragma once

#include <vector>

#include "grid/mask.h"

namespace sfw {

/// Follows the borders of a set, outer ones and those of holes.
///
/// Cells occur twice where the set is one cell wide. Linear in cells.
/// @return the cells of the set along each border, each an edge neighbour of the next, and the last
/// of the first; borders are in row-major order of their first cells.
std::vector<std::vector<Cell>> contours(const Mask& mask);

}  // namespace sfw
