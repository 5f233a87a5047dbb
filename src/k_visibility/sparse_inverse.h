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
  double wall_prior = 0.02;
};

SparseInverseConfig sparseInverseConfig(const Config& config);

/// A pose of the path with the number of walls to one access point.
struct CountedPose {
  Position antenna_in_map = Position::Zero();  ///< [m]
  int walls = 0;
};

/// The path as one access point hears it, in the order driven.
struct CountedPath {
  Position access_point = Position::Zero();  ///< [m], map frame
  std::vector<CountedPose> poses;
};

/// A place on a ray where the wall count is known.
struct CountedCell {
  std::size_t index = 0;  ///< along the ray, 0 = the access point's cell
  int walls = 0;
};

/// The stretch of a ray strictly between two places of known count.
struct RaySegment {
  std::size_t begin = 0;  ///< index of the first cell in between
  std::size_t end = 0;    ///< one past the last
  int walls = 0;          ///< dk: how many walls stand on it; negative if the counts contradict

  friend bool operator==(const RaySegment& a, const RaySegment& b) {
    return a.begin == b.begin && a.end == b.end && a.walls == b.walls;
  }
};

/// Cuts a ray at the places where it crosses the path (doc/method/k_visibility.md).
/// @param known in order along the ray, the access point itself first
/// @return the stretches that have cells, in order.
std::vector<RaySegment> segmentRay(const std::vector<CountedCell>& known);

/// How a segment's `walls` walls are spread over its `cells` cells: mass per cell, their sum
/// walls x wall_cells unless single cells would pass 1, where it is cut.
///
/// One bell for one wall, centred, sd cells/4; for more walls as many bells, evenly placed, sd
/// cells/(4 walls). The paper's equation 4 read right (doc/method/k_visibility.md).
std::vector<double> wallMass(std::size_t cells, int walls, double wall_cells);

/// What all rays together say of a cell.
struct CellEvidence {
  double weighted_mass = 0.0;  ///< sum of mass / variance
  double weight = 0.0;         ///< sum of 1 / variance; 0 if no ray says anything

  /// Wall mass fused by inverse variance; the paper's equation 5 for any number of rays.
  double mass() const { return weighted_mass / weight; }
};

/// Sparse inverse k-visibility: probability of being occupied for each cell, exactly 0.5 where
/// nothing is known (doc/method/k_visibility.md).
///
/// @param heard     one path for each access point; poses outside the grid are ignored
/// @param path      all poses in the order driven: Rule 1 frees their footprints
/// @param contacts  obstacles touched: they stay occupied under the footprint
/// @param stop      polled between rays; when it turns true the result is incomplete
/// Independent of the order of `heard`, up to the rounding of sums, and of poses that share a cell.
/// O(path cells x cells of a ray) for each access point.
Grid<float> inferOccupancy(const GridGeometry& geometry, const std::vector<CountedPath>& heard,
                           const std::vector<Position>& path, const std::vector<Contact>& contacts,
                           const SparseInverseConfig& config, const std::atomic<bool>& stop);

}  // namespace sfw
