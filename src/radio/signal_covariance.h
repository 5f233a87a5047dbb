#pragma once

namespace sfw {

/// Covariance of the mean signals of one access point at several positions, without the losses of
/// walls.
///
/// With d the distance of two positions and h 10 log10 of that to the access point:
///   C_ij = shadowing^2 exp(-d_ij / shadowing_distance) + [i = j] (noise_i + nugget)
///          + power_sd^2 + exponent_sd^2 h_i h_j
/// The estimator assumes this; the simulator's own shadowing is part of RadioModel.
struct SignalCovariance {
  double shadowing_db = 1.0;          ///< standard deviation that neighbouring positions share
  double shadowing_distance_m = 1.5;  ///< its correlation falls to 1/e here
  double nugget_db2 = 1.0;            ///< variance of a position's mean that no other one shares
  double power_sd_db = 20.0;          ///< prior standard deviation of the power at 1 m
  double exponent_sd = 0.35;          ///< prior standard deviation of the path loss exponent
};

}  // namespace sfw
