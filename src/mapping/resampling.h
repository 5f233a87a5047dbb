#pragma once

#include <vector>

#include "path/building_frame.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A grid of the building frame, and the value of everything beyond it.
struct BuildingRaster {
  const Grid<float>& values;
  float outside = 0.0F;
};

/// Resamples grids of the building frame on the grid of a map: linearly between the centres of the
/// four nearest cells.
/// @param rasters  at least one, all of the same geometry
/// @return one grid for each raster. O(cells of the map x rasters).
std::vector<Grid<float>> onMap(const GridGeometry& map, const std::vector<BuildingRaster>& rasters,
                               const BuildingFrame& frame);

}  // namespace sfw
