#pragma once

#include "grid/mask.h"

namespace sfw {

/// Distance of each cell's centre to the nearest cell of the set, in cells; 0 within the set and
/// infinity everywhere if it is empty.
///
/// Exact: squares are whole numbers until the final root. Cells outside the grid belong to no set.
/// Linear in cells (Meijster, Roerdink and Hesselink, "A general algorithm for computing distance
/// transforms in linear time", 2000).
Grid<double> distanceTransform(const Mask& mask);

}  // namespace sfw
