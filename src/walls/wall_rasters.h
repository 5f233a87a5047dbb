#pragma once

#include <array>

#include "belief/drive_features.h"
#include "grid/mask.h"

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

/// A stretch of cells between two cells of the footprint in the same row or column.
struct StripSums {
  Grid<float> sum;  ///< of the values in the stretch through each cell, smoothed along walls
  Mask in_strip;    ///< cells of such stretches
};

/// Sums values across the strips between two passes of a path.
/// @param footprint   of the robot
/// @param values      per cell; they count outside the footprint
/// @param along_rows  true: stretches lie in rows; false: in columns
/// @param widest      longest stretch [cells]
/// @param reach       mean over this many rows (or columns) to both sides [cells]
/// Linear in cells x reach.
StripSums stripSums(const Mask& footprint, const Grid<float>& values, bool along_rows,
                    std::int64_t widest, std::int64_t reach);

}  // namespace sfw
