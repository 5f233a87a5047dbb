#pragma once

#include <cstddef>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// The places where a robot may be: points of a square lattice near the mapped path.
class PlaceLattice {
 public:
  struct Config {
    double reach_m = 3.0;           ///< places farther from the mapped path are left out
    double deviation_m = 1.0;       ///< prior standard deviation of the distance from that path
    double finest_edge_m = 0.25;    ///< of a square of the lattice
    double coarsest_edge_m = 1.0;   ///< unless there would be more than most_points
    double wanted_points = 3000.0;  ///< the edge is chosen for about this number
    double most_points = 12000.0;
  };

  /// @param mapped  positions of the mapped path [m], not empty
  /// @throw InputError if they cover more than 20 million squares of the lattice
  PlaceLattice(const std::vector<Position>& mapped, const Config& config);

  std::size_t size() const { return points_.size(); }
  double edge() const { return edge_m_; }
  const std::vector<Position>& points() const { return points_; }

  /// Logarithm of the prior probability of each point; they sum to one.
  const std::vector<double>& logPrior() const { return log_prior_; }

  /// The number of the point nearest to a position among the four around it, or -1 beyond the
  /// lattice.
  int nearest(const Position& position) const;

  /// Bilinear interpolation of values at the points; -infinity beyond the lattice.
  double interpolated(const std::vector<double>& values, const Position& position) const;

 private:
  /// @param squares  of the distance from the mapped path [m2], of each square of the lattice
  void addPoints(const std::vector<double>& squares, const Config& config);
  int numberAt(int column, int row) const;

  double edge_m_ = 1.0;
  Position origin_ = Position::Zero();
  int width_ = 0;
  int height_ = 0;
  std::vector<int> numbers_;  // by row, then column; -1: left out
  std::vector<Position> points_;
  std::vector<double> log_prior_;
};

}  // namespace sfw
