#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A set of cells: 0 is outside, any other value is inside.
using Mask = Grid<std::uint8_t>;

}  // namespace sfw
