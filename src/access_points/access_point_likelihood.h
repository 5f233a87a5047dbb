#pragma once

#include <Eigen/Core>
#include <vector>

#include "access_points/law_terms.h"
#include "radio/radio_bins.h"
#include "radio/shadowing.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Marginal likelihood of the signals of an access point, given its position, for unknown power,
/// path loss and antenna pattern (doc/method/access_points.md).
class AccessPointLikelihood {
 public:
  /// Power, exponent, loss for each metre, and the first and second harmonic of the bearing. The
  /// harmonics are for access points that send more power to one side: by their antenna, by a wall
  /// behind them, or by a corridor. Without them the estimate moves to that side.
  static constexpr int kTerms = 1 + static_cast<int>(kLawTerms);

  /// Shadow fading by everything that the model leaves out, walls included.
  struct Shadowing {
    double deviation_db;  ///< standard deviation over positions
    double distance_m;    ///< distance at which its correlation is 1/e
  };

  /// @param access_point  its bins and height; its position is not used
  /// @param neighbours    of the bins' positions
  AccessPointLikelihood(AccessPointBins access_point, const Shadowing& shadowing,
                        const ShadowingWhitener::Neighbours& neighbours);

  /// Log likelihoods of positions [m], up to a constant that is the same for all positions and
  /// shadowings. O(positions x bins).
  std::vector<double> at(const std::vector<Position>& positions) const;
  double at(const Position& position) const { return at(std::vector{position}).front(); }

  /// Root mean square of the signals' residuals to the law fitted for a position [dB].
  double residualAt(const Position& position) const;

  const AccessPointBins& accessPoint() const { return access_point_; }

 private:
  using Terms = Eigen::Matrix<double, kTerms, 1>;
  using Information = Eigen::Matrix<double, kTerms, kTerms>;

  /// Sums of squares and products of whitened terms and signals, all scaled by the priors.
  struct Moments {
    Information information;  // includes that of the priors
    Terms pull;               // products with the residuals to the prior mean
    double residual;          // sum of squares of the residuals to the prior mean
  };

  static Moments momentsOf(const LawProducts& products);
  double logLikelihood(const LawProducts& products) const;

  AccessPointBins access_point_;
  ShadowingWhitener whitener_;
  double log_determinant_ = 0.0;  // of the whitener
  LawTermsAtBins terms_;
  Eigen::VectorXd signals_;
  Eigen::VectorXd white_ones_;
  Eigen::VectorXd white_signals_;
};

}  // namespace sfw
