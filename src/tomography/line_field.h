#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "grid/mask.h"
#include "radio/radio_bins.h"
#include "radio/signal_covariance.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Settings of line-field tomography (doc/method/walls.md).
struct LineFieldConfig {
  SignalCovariance covariance;           ///< of the bins' mean signals
  double max_total_wall_loss_db = 15.0;  ///< limit of the loss on a ray; infinity: losses add up
  double l1_weight = 0.03;               ///< weight of the sum of all losses
  double smoothness_weight = 8.0;        ///< weight of changes along a wall
  int iterations = 60;                   ///< in each of the two rounds; few iterations smooth
};

/// A grid whose cells' middle lines are the possible walls of two directions at right angles.
struct LineLattice {
  GridGeometry geometry;
  double yaw_rad = 0.0;  ///< of the grid's x axis in the building frame

  /// Rotates a point [m] about the frame's origin to the lattice's axes.
  Position toLattice(const Position& in_building) const {
    return yaw_rad == 0.0 ? in_building : Position(Eigen::Rotation2Dd(-yaw_rad) * in_building);
  }

  /// The inverse of toLattice.
  Position toBuilding(const Position& in_lattice) const {
    return yaw_rad == 0.0 ? in_lattice : Position(Eigen::Rotation2Dd(yaw_rad) * in_lattice);
  }
};

/// Signal loss of each piece of wall on a lattice.
struct LatticeLoss {
  /// All losses are 0.
  explicit LatticeLoss(const LineLattice& of)
      : lattice(of), walls_along_y(of.geometry), walls_along_x(of.geometry) {}

  LineLattice lattice;

  /// Losses [dB] of walls through the middle of each cell; 0 where no ray crosses the wall, or
  /// where the robot was.
  Grid<float> walls_along_y;  ///< rays along x cross them
  Grid<float> walls_along_x;  ///< rays along y cross them
};

/// Walls in all directions: the loss of a ray is the sum of its losses on each lattice.
using LineField = std::vector<LatticeLoss>;

/// Calls `visit(walls_along_y, Cell)` for each possible piece of wall between two points.
///
/// These are the cells whose middle lines the segment crosses strictly between its ends. Walls
/// along y come first. The order runs from low to high coordinates, whichever end is first.
/// @param from,to  [m], in the geometry's own axes, finite, in the grid or not
/// O(lines of the grid crossed).
template <class Visitor>
void forEachLine(const GridGeometry& geometry, const Position& from, const Position& to,
                 Visitor&& visit);

/// Sum of the losses between two points [m] of the building frame, without the limit of
/// max_total_wall_loss_db [dB]. O(lines crossed, over all lattices).
double lossBetween(const LineField& field, const Position& from, const Position& to);

/// Line-field tomography: estimates the walls from all readings of all access points at once.
///
/// Minimises 1/2 r' Q r + l1_weight sum w x + smoothness_weight sum sqrt(D^2 + 0.09) over losses x
/// >= 0 [dB]. Here r is the signal without log-distance path loss and (limited) wall losses. Q is
/// the inverse of SignalCovariance, and D is the change from cell to cell along a wall. Both
/// penalties express that walls are few, long and straight. FISTA (Beck and Teboulle 2009) runs
/// with w = 1, then again with w small where walls were found. The objective is convex if losses
/// add up. Deterministic.
///
/// @param lattices       of the result; walls may stand on all of them
/// @param access_points  with their bins, building frame
/// @param driven         for each lattice, the cells that the robot covered: no wall stands there
/// @param stop           polled; when it turns true the result is incomplete
/// O(iterations x (bins + crossings of rays with the lattices' lines)).
LineField solveLineField(const std::vector<LineLattice>& lattices,
                         const std::vector<AccessPointBins>& access_points,
                         const std::vector<Mask>& driven, const LineFieldConfig& config,
                         const std::atomic<bool>& stop);

template <class Visitor>
void forEachLine(const GridGeometry& geometry, const Position& from, const Position& to,
                 Visitor&& visit) {
  const Position a = geometry.toCells(from);
  const Position b = geometry.toCells(to);
  const Position size(static_cast<double>(geometry.width()),
                      static_cast<double>(geometry.height()));
  // Starts at the lower end, so that swapped ends give the same rounding. The slope of a line's own
  // direction is infinite and not used.
  const auto cross = [](Position low, Position high, const Position& grid, auto&& meet) {
    if (high.x() < low.x()) {
      std::swap(low, high);
    }
    const double slope = (high.y() - low.y()) / (high.x() - low.x());
    const double end = std::min(high.x(), grid.x());
    double line = std::max(std::floor(low.x() - 0.5) + 1.5, 0.5);
    while (line < end) {
      const double at = low.y() + (line - low.x()) * slope;
      if (at >= 0.0 && at < grid.y()) {
        meet(static_cast<std::int64_t>(line), static_cast<std::int64_t>(at));
      }
      line += 1.0;
    }
  };
  cross(a, b, size, [&](std::int64_t x, std::int64_t y) { visit(true, Cell{x, y}); });
  cross(a.reverse(), b.reverse(), size.reverse(), [&](std::int64_t y, std::int64_t x) {
    visit(false, Cell{x, y});
  });
}

}  // namespace sfw
