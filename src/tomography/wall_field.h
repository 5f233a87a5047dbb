#pragma once

#include <atomic>
#include <vector>

#include "tomography/line_field.h"

namespace sfw {

/// Settings of the estimate of walls from radio alone.
struct WallFieldConfig {
  LineFieldConfig line;
  int directions = 2;            ///< that walls may have, even, at equal angles
  double line_resolution = 0.2;  ///< edge of a member's cells [m]
  int members = 8;               ///< solutions that are averaged
  double left_out = 0.3;         ///< share of the bins that each member does not hear
};

/// What the radio alone says of walls, in the building frame.
struct WallField {
  /// Each of the averaged solutions.
  std::vector<LineField> members;

  /// Loss of the wall at each cell, mean over the members, all directions together; less close to
  /// the robot's footprint, from which it keeps walls away [dB].
  Grid<float> strength;

  /// Loss on the ray to each bin of each access point, as of lossBetween [dB].
  std::vector<std::vector<double>> ray_loss;
};

/// Sum of the losses between two points of the building frame, mean over the members, unsaturated
/// [dB].
double lossBetween(const WallField& field, const Position& from, const Position& to);

/// Solves the line field several times, with lattices shifted against each other and each time
/// without some of the bins, and averages: what all agree on stays sharp, the rest gets blurred as
/// it is uncertain. One solution alone puts walls at single places of many that explain as much.
///
/// @param geometry  of the result, building frame; finer than the members' lattice
/// @param path      cells of that geometry that the robot's antenna crossed
/// @param robot_radius  [m]; no wall stands closer to the path
/// @param stop      polled; when it turns true the result is incomplete
/// Deterministic. Cost: members times that of solveLineField, plus O(cells x members).
WallField estimateWalls(const GridGeometry& geometry, const std::vector<AccessPointBins>& heard,
                        const Mask& path, double robot_radius, const WallFieldConfig& config,
                        const std::atomic<bool>& stop);

}  // namespace sfw
