#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A set of cells: 0 is outside of it, anything else inside.
using Mask = Grid<std::uint8_t>;

/// Distance of each cell's centre to the nearest cell of the set, in cells; 0 within the set and
/// infinity everywhere if it is empty.
///
/// Exact: squares are whole numbers until the final root. Nothing outside the grid is looked at.
/// Linear in cells (Meijster, Roerdink and Hesselink, "A general algorithm for computing distance
/// transforms in linear time", 2000).
Grid<double> distanceTransform(const Mask& mask);

}  // namespace sfw
