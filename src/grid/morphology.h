#pragma once

#include <cstddef>
#include <cstdint>

#include "grid/mask.h"

namespace sfw {

/// The cells that are not in the set.
Mask complement(const Mask& mask);

/// The cells within `radius_cells` of the set, centre to centre. Linear in cells.
Mask dilated(const Mask& mask, double radius_cells);

/// Morphological closing with a disc: gaps too narrow for the disc are closed. The surroundings of
/// the grid count as outside the set. Linear in cells.
/// @throw std::invalid_argument if the radius is negative, not finite, or would not fit a grid.
Mask closed(const Mask& mask, double radius_cells);

/// The set with its holes: all cells that are not connected with the grid's edge outside the set,
/// over edge neighbours. Linear in cells.
Mask withHolesFilled(const Mask& mask);

/// Which cells around a cell are connected with it.
enum class Connectivity { kEdges, kEdgesAndCorners };

/// The connected parts of a set.
struct Components {
  Grid<std::int64_t> label;  ///< 0 outside the set, else 1..count in row-major order of first cells
  std::int64_t count = 0;
};

/// Labels the connected components of a set. Linear in cells.
Components labelComponents(const Mask& mask, Connectivity connectivity = Connectivity::kEdges);

}  // namespace sfw
