#pragma once

#include <string>

#include "simulation/building/floor_plan_io.h"

namespace sfw {

/// Reads a PNG as a floor plan, one pixel for each cell, as readFloorPlan describes.
/// @throw InputError naming the file if readPng refuses it, its scale is missing, or every white
/// area touches the image border.
Grid<CellState> readFloorPlanPng(const std::string& file, const FloorPlanOptions& options);

}  // namespace sfw
