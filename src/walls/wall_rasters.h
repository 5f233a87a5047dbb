#pragma once

#include <cstdint>
#include <vector>

#include "belief/drive_features.h"
#include "grid/mask.h"
#include "walls/grid_lines.h"

namespace sfw {

/// Evidence of walls by direction, on the grid of the cell features in the building frame.
/// `along_x` belongs to walls along the x axis, which a robot meets moving along y.
struct DirectedRasters {
  Grid<float> along_x;
  Grid<float> along_y;
};

/// The losses of the estimated walls by direction [dB per cell of a member's lattice].
struct DirectedLoss {
  DirectedRasters mean;    ///< over the members
  DirectedRasters spread;  ///< standard deviation over the members of the loss across 0.7 m [dB]
};

/// Averages the members of a wall field. Members must have two wall directions or more; those of
/// slanted walls are left out. Cost: cells x members.
DirectedLoss directedLoss(const WallField& walls, const GridGeometry& geometry);

/// Sums over the rays through each cell of the components of their directions.
/// O(cells crossed by rays).
DirectedRasters rayDirections(const GridGeometry& geometry,
                              const std::vector<AccessPointBins>& access_points);

/// Squared components of the headings with which a path crosses each cell; their sum is 1, or 0 off
/// the path.
DirectedRasters headings(const DrivenPath& path);

/// Neighbouring cells of one row or column, beside the footprint of the robot.
struct Stretch {
  std::int64_t line = 0;
  std::int64_t first = 0;  ///< place on the line
  std::int64_t end = 0;    ///< one past the last place
};

/// The stretches of all rows or columns of a grid.
struct Stretches {
  std::vector<Stretch> between_passes;  ///< from one cell of the footprint to the next
  std::vector<Stretch> beyond_passes;   ///< from the outermost cells outwards, and into wide gaps
};

/// Finds the stretches beside the footprint.
/// @param widest  a gap of more cells is no stretch between passes
/// @param beyond  length of the stretches beyond passes; in a wide gap, at most half of it [cells]
Stretches stretchesBeside(const Mask& footprint, const GridLines& lines, std::int64_t widest,
                          std::int64_t beyond);

/// Sums of values across stretches.
struct StripSums {
  Grid<float> sum;  ///< of the values in the stretch through each cell, smoothed along walls
  Mask in_strip;    ///< cells of stretches
};

/// Sums values across stretches.
/// @param values  per cell
/// @param reach   mean over this many rows (or columns) to both sides [cells]
/// Linear in cells x reach.
StripSums stripSums(const Grid<float>& values, const GridLines& lines,
                    const std::vector<Stretch>& stretches, std::int64_t reach);

}  // namespace sfw
