#pragma once

#include <vector>

#include "grid/mask.h"

namespace sfw {

/// The borders of a set: for each, the cells of the set along it, each an edge neighbour of the one
/// before, the first one of the last. The outer border and those of holes; where the set is one
/// cell wide, cells occur twice. In row-major order of their first cells. Linear in cells.
std::vector<std::vector<Cell>> contours(const Mask& mask);

}  // namespace sfw
