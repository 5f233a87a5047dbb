#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/wall_segment.h"

namespace sfw {

/// Lines of a map for programs that draw: walls and the outline of the free space.
struct FloorDrawing {
  std::vector<WallSegment> walls;

  /// Closed polygons through the centres of the free cells at a border, of holes too [m]. The last
  /// point is joined to the first.
  std::vector<std::vector<Position>> free_outlines;

  Box area = {};  ///< around all lines, or the whole map if there are none [m]
};

/// Draws a map in lines. Linear in cells.
FloorDrawing floorDrawing(const Snapshot& snapshot);

/// The text of walls.yaml: `{format, frame, unit, walls: [{from, to, confidence, outer}]}`, in
/// metres of the map frame, rounded to millimetres.
std::string wallsYaml(const std::vector<WallSegment>& walls);

/// Reads the walls of a walls.yaml.
/// @throw InputError naming the file, and the wall that cannot be used
std::vector<WallSegment> readWalls(const std::string& file);

/// The text of walls.svg at a scale of 1:50, with layers for Inkscape. The coordinates in the
/// layers are metres of the map frame. The opacity of a wall is its confidence. Outer
/// walls are dashed, on a layer of their own.
std::string wallsSvg(const FloorDrawing& drawing);

/// The text of walls.dxf, version R12, in metres of the map frame: a LINE for each wall on the
/// layer WALLS or, for outer walls, OUTER_WALLS, and a closed POLYLINE for each outline on the
/// layer FREE.
std::string wallsDxf(const FloorDrawing& drawing);

}  // namespace sfw
