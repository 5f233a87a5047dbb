#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// What a cell of a known building is made of.
enum class Material : std::uint8_t { kUnknown, kFree, kInteriorWall, kOuterWall };

/// A known building, for simulation: one raster with its walls' materials.
using FloorPlan = Grid<Material>;

/// Both kinds of wall as occupied.
Grid<CellState> toStates(const FloorPlan& plan);

/// Tells outer from interior walls.
///
/// The outside is all beyond the grid, and the unknown cells that hang together with it over their
/// edges; unknown cells that walls enclose (a shaft, a cupboard) are not. A wall cell is outer if
/// the outside begins within 0.5 m of it, unless it lies in a gap of at most 0.4 m between free
/// cells: so an interior wall stays interior up to the façade that it meets. Free specks that are
/// nowhere 0.4 m wide, as scanners leave them behind windows, count as neither.
/// Good to a cell or two where walls meet and at the tips of corners. Linear in cells.
FloorPlan withMaterials(const Grid<CellState>& states);

}  // namespace sfw
