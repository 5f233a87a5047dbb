#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A set of cells: 0 is outside of it, anything else inside.
using Mask = Grid<std::uint8_t>;

}  // namespace sfw
