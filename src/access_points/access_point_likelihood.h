#pragma once

#include <Eigen/Core>

#include "radio/radio_bins.h"
#include "radio/shadowing.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// How likely the signals of an access point are if it stands at a place, whatever its power, path
/// loss and pattern (doc/method/access_points.md).
class AccessPointLikelihood {
 public:
  /// Power, exponent, loss for each metre, and the first and second harmonic of bearing: an antenna
  /// that favours one side looks as if it stood nearer to it, and so does one with a wall at its
  /// back or in a corridor.
  static constexpr int kTerms = 7;

  /// What shadows signals where no wall is modelled: how strongly, and how far along.
  struct Shadowing {
    double deviation_db;
    double distance_m;
  };

  /// @param heard  its position is not looked at
  AccessPointLikelihood(AccessPointBins heard, const Shadowing& shadowing);

  /// Logarithm, up to a constant that is the same for all places and shadowings. O(bins).
  double at(const Position& place) const;

  /// Root mean square of the signals to the law fitted for that place [dB].
  double residualAt(const Position& place) const;

  const AccessPointBins& heard() const { return heard_; }

 private:
  using Terms = Eigen::Matrix<double, kTerms, 1>;
  using Information = Eigen::Matrix<double, kTerms, kTerms>;

  /// All but the first term, which is one everywhere.
  using Basis = Eigen::Matrix<double, Eigen::Dynamic, kTerms - 1, Eigen::RowMajor>;

  /// Sums of squares and products of whitened terms and signals, all scaled by the priors.
  struct Moments {
    Information information;  // of the priors too
    Terms pull;               // of what the prior mean leaves
    double residual;          // squared, to the prior mean
  };

  Basis basisAt(const Position& place) const;
  Moments momentsAt(const Position& place) const;

  AccessPointBins heard_;
  ShadowingWhitener whitener_;
  double log_determinant_ = 0.0;  // of the whitener
  Eigen::ArrayXd x_, y_;          // of the bins
  Eigen::VectorXd signals_;
  Eigen::VectorXd white_ones_;
  Eigen::VectorXd white_signals_;
};

}  // namespace sfw
