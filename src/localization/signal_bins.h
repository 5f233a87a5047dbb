#pragma once

#include <Eigen/Core>
#include <vector>

#include "localization/signal_field.h"

namespace sfw {

/// Readings of one BSSID averaged in squares of the floor.
struct SignalBins {
  std::vector<Position> positions;  ///< mean of the readings' [m]
  std::vector<double> rssi_dbm;     ///< mean
  std::vector<double> readings;     ///< how many, each at least 1
  double noise_db2 = 4.0;           ///< variance of a reading about its bin's mean
};

/// Bins of 0.5 m, larger if there would be more than 250. The order of samples does not matter.
SignalBins signalBins(const std::vector<Sample>& samples);

/// Mean of the log-distance law at its prior means of power and exponent [dBm].
double priorMean(const SignalLaw& law, const Position& position);

/// What one prior standard deviation of power, and one of the exponent, adds [dB].
Eigen::Vector2d signalBasis(const SignalLaw& law, const Position& position);

}  // namespace sfw
