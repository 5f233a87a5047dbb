#pragma once

#include <Eigen/Core>
#include <vector>

#include "localization/place_lattice.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Where a scan was taken.
struct PlaceEstimate {
  Position position = Position::Zero();                  ///< mean [m], map frame
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< [m2]
  /// Probability of being within 2 m of `position`, in 0..1.
  double sure = 0.0;
};

/// The radius of PlaceEstimate::sure [m].
constexpr double kSureWithinM = 2.0;

/// Mean, covariance and sureness of weighted positions.
/// @param weights  at least 0, not all 0
PlaceEstimate estimateOf(const std::vector<Position>& positions,
                         const std::vector<double>& weights);

/// Probability of each place after one scan.
/// @param log_likelihood  of each place, as of RadioMap::logLikelihood
std::vector<double> posterior(const PlaceLattice& places,
                              const std::vector<double>& log_likelihood);

}  // namespace sfw
