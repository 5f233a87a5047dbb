#pragma once

#include <memory>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/grid_geometry.h"

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace sfw {

/// Occupancy probability of each cell, stored in MRPT's occupancy grid. Immutable.
///
/// MRPT stores log-odds of being FREE in 1/16 steps of an int8, so probabilities are rounded to
/// that scale and end at 0.00036 and 0.99964.
class SFW_EXPORT BeliefMap {
 public:
  /// Creates a map without any known cell.
  /// @throw std::invalid_argument if MRPT cannot hold the geometry.
  BeliefMap(const GridGeometry& geometry, const Config::Belief& config);

  /// Creates a map of probabilities.
  /// @param occupied  probability of being occupied; a value outside [0, 1] counts as 0.5
  /// @param config    thresholds of free and occupied
  /// @throw std::invalid_argument if MRPT cannot hold the geometry.
  BeliefMap(const Grid<float>& occupied, const Config::Belief& config);

  /// The same map elsewhere. MRPT's grid stays at its place, since it counts in single precision;
  /// so `by` may be far from zero.
  BeliefMap moved(const Position& by) const;

  /// The grid of the map.
  const GridGeometry& geometry() const { return geometry_; }

  /// MRPT's grid, for programs that use MRPT; include <mrpt/maps/COccupancyGridMap2D.h>.
  const mrpt::maps::COccupancyGridMap2D& grid() const { return *grid_; }

  /// Probability that a contained cell is occupied.
  float occupied(Cell c) const;

  /// True if there is any evidence for a contained cell.
  bool known(Cell c) const;

  /// Free, occupied or unknown, by the thresholds of the configuration.
  CellState state(Cell c) const;

 private:
  GridGeometry geometry_;
  Config::Belief config_;
  std::shared_ptr<const mrpt::maps::COccupancyGridMap2D> grid_;  // never changes: copies share it
};

}  // namespace sfw
