#pragma once

#include <atomic>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Settings of sparse inverse k-visibility; Config explains each one.
struct SparseInverseConfig {
  double footprint_radius_m = 0.15;
  double max_gap_m = 1.0;
  double wall_thickness_m = 0.10;
  double wall_prior = 0.02;  ///< share of the area, 0 to 1
};

/// The settings of a Config for sparse inverse k-visibility.
SparseInverseConfig sparseInverseConfig(const Config& config);

/// A pose of the path with the number of walls to one access point.
struct CountedPose {
  Position antenna_in_map = Position::Zero();  ///< [m]
  int walls = 0;
  bool is_last = false;  ///< of its robot: no way leads to the next pose
};

/// The poses with readings of one access point, by robot and time.
struct CountedPath {
  Position access_point = Position::Zero();  ///< [m], map frame
  std::vector<CountedPose> poses;
};

/// A cell on a ray where the wall count is known.
struct CountedCell {
  std::size_t index = 0;  ///< along the ray, 0 = the access point's cell
  int walls = 0;
};

/// The cells of a ray strictly between two cells of known count.
struct RaySegment {
  std::size_t begin = 0;  ///< index of the first cell in between
  std::size_t end = 0;    ///< one past the last
  int walls = 0;          ///< dk: number of walls on it; negative if the counts contradict

  friend bool operator==(const RaySegment& a, const RaySegment& b) {
    return a.begin == b.begin && a.end == b.end && a.walls == b.walls;
  }
};

/// Cuts a ray where it crosses the path (doc/method/k_visibility.md).
/// @param known  in order along the ray, the access point itself first
/// @return the stretches that have cells, in order.
std::vector<RaySegment> segmentRay(const std::vector<CountedCell>& known);

/// Spreads the walls of a segment over its cells as wall mass (doc/method/k_visibility.md).
///
/// One wall gives one centred bell curve of standard deviation cells/4; more walls give as many,
/// evenly spaced, of cells/(4 walls). The paper draws its equation 4 this way, although the formula
/// there is zero at the midpoint.
/// @param cells       of the segment
/// @param wall_cells  thickness of a wall in cells
/// @return mass of each cell, at most 1; the sum is walls x wall_cells unless a cell was cut to 1.
std::vector<double> wallMass(std::size_t cells, int walls, double wall_cells);

/// Evidence of all rays for a cell.
struct CellEvidence {
  double weighted_mass = 0.0;  ///< sum of mass / variance
  double weight = 0.0;         ///< sum of 1 / variance; 0 if no ray crosses the cell

  /// Wall mass fused by inverse variance: the paper's equation 5 for any number of rays.
  double mass() const { return weighted_mass / weight; }
};

/// Sparse inverse k-visibility: infers the occupancy of cells from wall counts along the path
/// (doc/method/k_visibility.md).
///
/// @param counted   one path for each access point; poses outside the grid are ignored
/// @param path      all antenna positions [m] by time, map frame: Rule 1 frees their footprints
/// @param contacts  obstacles touched: they stay occupied under the footprint
/// @param stop      polled between rays; when it turns true the result is incomplete
/// @return probability of being occupied for each cell; exactly 0.5 where nothing is known.
/// Independent of the order of access points, up to the rounding of sums, and of the order of poses
/// that share a cell.
/// O(path cells x cells of a ray) for each access point.
Grid<float> inferOccupancy(const GridGeometry& geometry, const std::vector<CountedPath>& counted,
                           const std::vector<Position>& path, const std::vector<Contact>& contacts,
                           const SparseInverseConfig& config, const std::atomic<bool>& stop);

}  // namespace sfw
