#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "structure_from_wifi/types.h"

namespace sfw {

/// The position of an access point, estimated from its readings, and from its given position if
/// that has a standard deviation.
struct AccessPointEstimate {
  Position position = Position::Zero();                  ///< [m], map frame
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< [m2], about the position

  /// The readings fit another position about as well, such as the mirror image beyond a straight
  /// path. The position is then the likeliest one, and the covariance spans the others too.
  bool ambiguous = false;

  std::size_t readings = 0;  ///< used for the estimate
  std::size_t bins = 0;      ///< square cells of floor that hold these readings
};

/// Measures how well the readings of an access point fit its given position.
struct AccessPointFit {
  double residual_db = 0.0;  ///< root mean square distance of the bins' means to the fitted law
  double log_ratio = 0.0;    ///< log likelihood of the estimate less that of the position, >= 0;
                             ///< of a position with a deviation: see accessPointFit
  double distance_m = 0.0;   ///< from the given position to the estimate
  bool suspect = false;      ///< the readings contradict the given position
  AccessPointEstimate estimate;  ///< the position that fits the readings best
};

}  // namespace sfw
