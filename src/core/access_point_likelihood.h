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
  /// Power, exponent, loss for each metre, and the first harmonic of the access point's pattern: an
  /// antenna that favours one side looks as if it stood nearer to it.
  static constexpr int kTerms = 5;
  using Basis = Eigen::Matrix<double, Eigen::Dynamic, kTerms, Eigen::RowMajor>;

  /// @param heard  its position is not looked at
  explicit AccessPointLikelihood(HeardAccessPoint heard);

  /// Logarithm, up to a constant. O(bins).
  double at(const Position& place) const;

  /// Root mean square of the signals to the law fitted for that place [dB].
  double residualAt(const Position& place) const;

  const HeardAccessPoint& heard() const { return heard_; }

 private:
  Basis basisAt(const Position& place) const;
  Basis whiteBasis(const Position& place) const;

  HeardAccessPoint heard_;
  ShadowingWhitener whitener_;
  Eigen::VectorXd signals_;
  Eigen::VectorXd white_signals_;
};

}  // namespace sfw
