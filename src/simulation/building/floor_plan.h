#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The material of a cell of a known building.
enum class Material : std::uint8_t { kUnknown, kFree, kInteriorWall, kOuterWall };

/// A known building for simulation: a raster with the materials of its walls.
using FloorPlan = Grid<Material>;

/// The cell states of a floor plan. Both kinds of wall are occupied.
Grid<CellState> toStates(const FloorPlan& plan);

/// Distinguishes outer walls from interior walls.
///
/// The outside is everything beyond the grid, and the unknown cells connected with it over their
/// edges. Unknown cells that walls enclose (a shaft, a cupboard) are inside. A wall cell is outer
/// if the outside begins within 0.5 m of it, unless it lies in a gap of at most 0.4 m between free
/// cells. So an interior wall stays interior up to the façade that it meets. Free specks narrower
/// than 0.4 m everywhere are ignored; scanners leave such specks behind windows.
/// The result may be wrong by one or two cells where walls meet and at the tips of corners. Linear
/// in cells.
FloorPlan withMaterials(const Grid<CellState>& states);

}  // namespace sfw
