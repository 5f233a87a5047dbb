#pragma once

#include <atomic>
#include <vector>

#include "tomography/kept_members.h"
#include "tomography/line_field.h"

namespace sfw {

/// Settings of the estimate of walls from radio alone.
struct WallFieldConfig {
  LineFieldConfig line;
  int wall_directions = 2;         ///< that walls may have, even, at equal angles
  double line_resolution_m = 0.2;  ///< edge of a cell of the members' lattices
  int ensemble_size = 8;           ///< members: solutions that are averaged
  double holdout_fraction = 0.3;   ///< share of the bins that each member leaves out
};

/// Walls estimated from radio alone, in the building frame.
struct WallField {
  /// The averaged solutions.
  std::vector<LineField> members;

  /// Loss of the wall in each cell [dB]: the mean over the members of the sum over all directions.
  /// It is reduced close to the robot's footprint, because robots keep away from walls.
  Grid<float> loss_db;

  /// Loss on the ray to each bin of each access point [dB], as of lossBetween.
  std::vector<std::vector<double>> ray_loss_db;
};

/// Sum of the losses between two points [m] of the building frame, mean over the members, without
/// the limit of max_total_wall_loss_db [dB]. O(members x lines crossed).
double lossBetween(const WallField& field, const Position& from, const Position& to);

/// Estimates the walls by an ensemble of line fields.
///
/// Each member shifts the lattices by a part of a cell, leaves out some of the bins, and solves the
/// line field. The mean keeps walls that the members agree on sharp and blurs uncertain ones. A
/// single solution puts walls at one of many positions that explain the signals equally well.
///
/// @param geometry        of the result, building frame; finer than the members' lattices
/// @param access_points   with their bins, building frame
/// @param path            cells of that geometry that the robot's antenna crossed
/// @param robot_radius_m  no wall stands closer to the path
/// @param stop            polled; when it turns true the result is incomplete
/// Deterministic. Cost: that of solveLineField for each member, plus O(cells x members).
WallField estimateWalls(const GridGeometry& geometry,
                        const std::vector<AccessPointBins>& access_points, const Mask& path,
                        double robot_radius_m, const WallFieldConfig& config,
                        const std::atomic<bool>& stop);

/// Estimates the walls of a live map as estimateWalls does, but with members of earlier refreshes.
/// @param kept  of the refresh before, with the same settings; refreshed
WallField refreshWalls(const WallData& data, double robot_radius_m, const WallFieldConfig& config,
                       const std::atomic<bool>& stop, KeptMembers& kept);

}  // namespace sfw
