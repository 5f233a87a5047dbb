#pragma once

#include <string>
#include <vector>

#include "simulation/building/floor_plan.h"

namespace sfw {

/// The scale at which a file becomes cells.
struct FloorPlanOptions {
  double resolution_m = 0.05;     ///< of plans drawn in metres (HouseExpo) [m]
  double metres_per_pixel = 0.0;  ///< scale of a PNG; 0: unknown
};

/// Every problem of the options, one sentence each that starts with the option's name.
std::vector<std::string> validate(const FloorPlanOptions& options);

/// Reads a floor plan from a file of one of three kinds. The extension decides the kind, or else
/// the content:
///
/// - HouseExpo JSON: `verts` is the outline of the free space [m]; walls are its slits and notches.
///   Cells whose centre is inside (even-odd) are free. Cells outside within 0.15 m of free cells,
///   or in gaps of up to 0.6 m between them, are wall: so a slit is wall throughout. A slit between
///   the centres of neighbouring cells becomes one cell of wall. The grid's edges are whole
///   multiples of the resolution, at least 0.5 m away from free space.
/// - map_server YAML beside its image, as readMap reads it.
/// - PNG with options.metres_per_pixel, lower left corner at the map frame's origin. Pixels darker
///   than middle grey are wall. Transparent pixels are unknown, unless walls enclose more of them
///   than there are light pixels: then they are floor, as in drawings of walls alone. White areas
///   that touch the image border are outside the building.
///
/// Walls get their materials from withMaterials.
/// @throw InputError naming the file and its problem: unreadable, malformed, without free cells,
/// larger than 64 million cells, or an option out of range or missing.
/// O(cells + rows and columns crossed by the outline).
FloorPlan readFloorPlan(const std::string& file, const FloorPlanOptions& options = {});

}  // namespace sfw
