#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "grid/mask.h"
#include "radio/radio_bins.h"
#include "radio/shadowing.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Settings of line-field tomography (doc/method/walls.md).
struct LineFieldConfig {
  ShadowingModel shadowing;
  double saturation_db = 15.0;  ///< losses of all walls together stay below; infinity: they add up
  double sparsity = 0.03;       ///< weight of the sum of all losses
  double straightness = 8.0;    ///< weight of changes along a wall
  int iterations = 60;          ///< of each of the two rounds; few: stopping early smooths
};

/// Where walls may stand that lie in two directions at right angles: on the middle lines of the
/// cells of a grid that is turned against the building's axes.
struct LineLattice {
  GridGeometry geometry;
  double yaw_rad = 0.0;  ///< of the grid's x axis in the building frame

  /// Coordinates along the lattice's axes: a rotation about the origin.
  Position toLattice(const Position& in_building) const {
    return Eigen::Rotation2Dd(-yaw_rad) * in_building;
  }
  Position toBuilding(const Position& in_lattice) const {
    return Eigen::Rotation2Dd(yaw_rad) * in_lattice;
  }
};

/// How much signal each piece of wall on a lattice takes away.
struct LatticeLoss {
  explicit LatticeLoss(const LineLattice& of)
      : lattice(of), across_x(of.geometry), across_y(of.geometry) {}

  LineLattice lattice;

  /// Loss [dB] of a wall through the middle of each cell, along y (`across_x`: rays that run along
  /// x cross it) or along x (`across_y`); 0 where no ray crosses or the robot has been.
  Grid<float> across_x;
  Grid<float> across_y;
};

/// Walls in all directions: a ray loses what it loses on each lattice.
using LineField = std::vector<LatticeLoss>;

/// Calls `visit(across_x, Cell)` for each piece of wall that could stand between two points: the
/// cells whose middle lines the segment crosses strictly between its ends, those of columns
/// (`across_x` true) first. The order is that from low to high coordinates, whichever end is first.
/// @param from,to  in the geometry's own axes, finite, in the grid or not
/// O(lines of the grid crossed).
template <class Visitor>
void forEachLine(const GridGeometry& geometry, const Position& from, const Position& to,
                 Visitor&& visit);

/// Sum of the losses between two points of the building frame, before saturation [dB].
double lossBetween(const LineField& field, const Position& from, const Position& to);

/// Line-field tomography: walls from all readings of all access points at once.
///
/// Minimises 1/2 r' Q r + sparsity sum w x + straightness sum sqrt(D^2 + 0.09) over x >= 0, where r
/// is the signal less log-distance path loss and saturated wall losses, Q the inverse covariance of
/// shadowing, noise and unknown power and exponent (SignalPrecision), and D the change from cell to
/// cell along a wall: walls are few, long and straight. FISTA (Beck and Teboulle 2009), then again
/// with w small where walls were found. Convex without saturation; deterministic.
///
/// @param lattices  of the result; walls may stand on all of them
/// @param heard     building frame
/// @param driven    for each lattice, the cells that the robot covered: no wall stands there
/// @param stop      polled; when it turns true the result is incomplete
/// O(iterations x (bins + crossings of rays with the lattices' lines)).
LineField solveLineField(const std::vector<LineLattice>& lattices,
                         const std::vector<AccessPointBins>& heard, const std::vector<Mask>& driven,
                         const LineFieldConfig& config, const std::atomic<bool>& stop);

template <class Visitor>
void forEachLine(const GridGeometry& geometry, const Position& from, const Position& to,
                 Visitor&& visit) {
  const Position a = geometry.toCells(from);
  const Position b = geometry.toCells(to);
  const Position size(static_cast<double>(geometry.width()),
                      static_cast<double>(geometry.height()));
  // From the lower end on, so that swapped ends round alike; the slope of a line's own direction
  // is infinite and not used.
  const auto cross = [](Position low, Position high, const Position& grid, auto&& meet) {
    if (high.x() < low.x()) {
      std::swap(low, high);
    }
    const double slope = (high.y() - low.y()) / (high.x() - low.x());
    const double end = std::min(high.x(), grid.x());
    for (double line = std::max(std::floor(low.x() - 0.5) + 1.5, 0.5); line < end; line += 1.0) {
      const double at = low.y() + (line - low.x()) * slope;
      if (at >= 0.0 && at < grid.y()) {
        meet(static_cast<std::int64_t>(line), static_cast<std::int64_t>(at));
      }
    }
  };
  cross(a, b, size, [&](std::int64_t x, std::int64_t y) { visit(true, Cell{x, y}); });
  cross(a.reverse(), b.reverse(), size.reverse(), [&](std::int64_t y, std::int64_t x) {
    visit(false, Cell{x, y});
  });
}

}  // namespace sfw
