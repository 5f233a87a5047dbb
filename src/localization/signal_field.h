#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "radio/signal_covariance.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Predicted readings at several positions.
struct SignalPrediction {
  std::vector<double> mean_dbm;
  std::vector<double> deviation_db;  ///< standard deviation of one new reading
};

/// What is learned of one BSSID besides its readings.
struct SignalLaw {
  SignalCovariance covariance;     ///< power and exponent are those of the mean
  double noise_db2 = 4.0;          ///< variance of one reading at one position
  std::optional<Position> source;  ///< where the log-distance law starts; none: a constant mean
};

/// The signal strength of one BSSID over the floor: a Gaussian process.
///
/// Its mean is the log-distance law about the source, or a constant. Its covariance is that of
/// SignalCovariance: exponential shadowing with a nugget. Readings are averaged in square bins. A
/// bin far from what its neighbours predict gets more noise. A prediction uses the nearest eight
/// bins (Vecchia 1988); power and exponent are marginalised.
class SignalField {
 public:
  /// @param samples  in any order, not empty
  /// @param law      as of learnSignalLaw
  SignalField(const std::vector<Sample>& samples, const SignalLaw& law);

  /// Predicts readings. O(positions).
  SignalPrediction predict(const std::vector<Position>& positions) const;

 private:
  void fitMean();
  void distrustOutliers();

  SignalLaw law_;
  std::vector<Position> positions_;  // of the bins
  std::vector<double> noise_db2_;    // of each bin's mean
  Eigen::VectorXd residual_;         // to the prior mean [dB]
  Eigen::VectorXd around_mean_;      // to the fitted mean [dB]
  Eigen::MatrixX2d basis_;           // of each bin
  Eigen::Vector2d coefficients_;     // of power and exponent, in prior standard deviations
  Eigen::Matrix2d coefficients_variance_;
};

/// Learns the law of one BSSID: shadowing, its reach and the nugget by the largest posterior
/// density; the source by the largest marginal likelihood, unless it is known.
///
/// The priors are log-normal: shadowing 4 dB, reach 5 m, nugget 4 dB2, each within a factor of two.
/// A source that is not better than a constant mean by e^2 is left out.
/// @param samples  in any order, not empty
/// @param place    of the access point, if known
/// The cost is bounded by 250 bins and 600 places of the source: 10 ms.
SignalLaw learnSignalLaw(const std::vector<Sample>& samples, std::optional<Position> place);

/// The same with a constant mean.
SignalLaw learnConstantLaw(const std::vector<Sample>& samples);

}  // namespace sfw
