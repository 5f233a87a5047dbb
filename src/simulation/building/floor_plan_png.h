#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "simulation/building/floor_plan_io.h"

namespace sfw {

/// Whether bytes begin with the signature of a PNG.
bool isPng(std::string_view bytes);

/// Reads a PNG as a floor plan, one pixel for each cell, as readFloorPlan describes.
/// @throw InputError naming the file if it cannot be decoded, its scale is missing, it has more
/// than `max_cells` pixels, or every white area touches the image border.
Grid<CellState> readFloorPlanPng(const std::string& file, const FloorPlanOptions& options,
                                 std::int64_t max_cells);

}  // namespace sfw
