#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/grid_geometry.h"

namespace mrpt::maps {
class COccupancyGridMap2D;
}

namespace sfw {

/// What a map holds of a cell.
struct CellBelief {
  float occupied;   ///< probability
  bool known;       ///< there is any evidence
  CellState state;  ///< free, occupied or unknown, by the thresholds of the configuration
};

/// Occupancy probability of each cell, as MRPT's occupancy grid stores it. Immutable.
///
/// MRPT stores log-odds of being FREE in 1/16 steps of an int8, so probabilities are rounded to
/// that scale and end at 0.00036 and 0.99964.
class SFW_EXPORT BeliefMap {
 public:
  /// Creates a map without any known cell.
  /// @throw std::invalid_argument if the geometry lies farther out than
  /// GridGeometry::kFarthestMap.
  BeliefMap(const GridGeometry& geometry, const Config::Belief& config);

  /// Creates a map of probabilities.
  /// @param occupied  probability of being occupied; a value outside [0, 1] counts as 0.5
  /// @param config    thresholds of free and occupied
  /// @throw std::invalid_argument if the geometry lies farther out than
  /// GridGeometry::kFarthestMap.
  BeliefMap(const Grid<float>& occupied, const Config::Belief& config);

  /// The same map elsewhere. MRPT's grid stays at its place, since it counts in single precision;
  /// so `by` may be far from zero.
  BeliefMap moved(const Position& by) const;

  /// The grid of the map.
  const GridGeometry& geometry() const { return geometry_; }

  /// MRPT's grid, for programs that use MRPT; include <mrpt/maps/COccupancyGridMap2D.h>. The first
  /// call makes it, and loads MRPT's libraries.
  /// @throw std::invalid_argument if MRPT cannot hold the geometry.
  /// @throw std::runtime_error if libstructure_from_wifi_mrpt.so cannot be loaded.
  const mrpt::maps::COccupancyGridMap2D& grid() const;

  /// What the map holds of a contained cell.
  const CellBelief& operator[](Cell c) const { return values_[valueAt(c)]; }

  /// Probability that a contained cell is occupied.
  float occupied(Cell c) const { return (*this)[c].occupied; }

  /// True if there is any evidence for a contained cell.
  bool known(Cell c) const { return (*this)[c].known; }

  /// Free, occupied or unknown, by the thresholds of the configuration.
  CellState state(Cell c) const { return (*this)[c].state; }

  /// `convert(CellBelief)` of every cell, row-major from the lowest y.
  ///
  /// It is called only for each of the 256 values that a cell can have. O(cells).
  template <class Convert>
  auto converted(Convert&& convert) const {
    std::array<decltype(convert(values_[0])), kValues> table{};
    for (std::size_t i = 0; i < kValues; ++i) {
      table[i] = convert(values_[i]);
    }
    std::vector<decltype(convert(values_[0]))> all(log_odds_->size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = table[static_cast<std::uint8_t>((*log_odds_)[i])];
    }
    return all;
  }

 private:
  static constexpr std::size_t kValues = 256;
  struct MrptGrid;

  BeliefMap(const GridGeometry& geometry, const Config::Belief& config,
            std::vector<std::int8_t> log_odds);

  std::size_t valueAt(Cell c) const {
    return static_cast<std::uint8_t>((*log_odds_)[geometry_.index(c)]);
  }

  GridGeometry geometry_;
  std::array<CellBelief, kValues> values_;  // by log odds without sign
  // Copies share these:
  std::shared_ptr<const std::vector<std::int8_t>> log_odds_;  // of being free, in MRPT's steps
  std::shared_ptr<MrptGrid> mrpt_grid_;
};

}  // namespace sfw
