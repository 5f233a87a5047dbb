#pragma once

#include <cstddef>
#include <cstdint>

#include "grid/mask.h"

namespace sfw {

/// The cells that are not in the set.
Mask complement(const Mask& mask);

/// The cells within `radius_cells` of the set, centre to centre. Linear in cells.
Mask dilated(const Mask& mask, double radius_cells);

/// The set dilated, then eroded with the same disc: gaps in which the disc finds no room are
/// closed. The surroundings of the grid count as outside the set. Linear in cells.
/// @throw std::invalid_argument if the radius is negative, not finite, or would not fit a grid.
Mask closed(const Mask& mask, double radius_cells);

/// The set with every cell from which no way over edge neighbours outside the set leads off the
/// grid. Linear in cells.
Mask withHolesFilled(const Mask& mask);

/// Cells of a set that hang together over their edges.
struct Components {
  Grid<std::int64_t> label;  ///< 0 outside the set, else 1..count in row-major order of first cells
  std::int64_t count = 0;
};

/// Labels the 4-connected components of a set. Linear in cells.
Components labelComponents(const Mask& mask);

}  // namespace sfw
