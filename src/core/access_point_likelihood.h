#pragma once

#include <Eigen/Core>

#include "structure_from_wifi/radio_bins.h"
#include "structure_from_wifi/shadowing.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// How likely the signals of an access point are if it stands at a place, whatever its power, path
/// loss and pattern (doc/algorithm.md).
class AccessPointLikelihood {
 public:
  /// @param heard  its position is not looked at
  explicit AccessPointLikelihood(HeardAccessPoint heard);

  /// Logarithm, up to a constant. O(bins).
  double at(const Position& place) const;

  /// Root mean square of the signals to the law fitted for that place [dB].
  double residualAt(const Position& place) const;

  const HeardAccessPoint& heard() const { return heard_; }

 private:
  Eigen::MatrixXd basisAt(const Position& place) const;
  Eigen::MatrixXd whiteBasis(const Position& place) const;

  HeardAccessPoint heard_;
  ShadowingWhitener whitener_;
  Eigen::VectorXd signals_;
  Eigen::VectorXd white_signals_;
  Eigen::VectorXd white_one_;
};

}  // namespace sfw
