#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "path/building_frame.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Signals of one access point heard at nearly the same place.
struct RadioBin {
  Position place = Position::Zero();  ///< their mean [m], building frame
  double rssi_dbm = 0.0;              ///< their mean
  double readings = 0.0;              ///< how many
};

/// What is heard of one access point, thinned to what inference can tell apart.
struct AccessPointBins {
  Position position = Position::Zero();  ///< [m], building frame
  std::optional<double> height_m;        ///< above the floor
  double noise_db2 = 0.0;                ///< variance of one reading at one place
  std::vector<RadioBin> bins;
};

/// Puts the readings of one access point into square bins of `bin_m`, in row-major order.
///
/// Bins closer than 0.3 m to the access point are left out: there the log-distance law ends. The
/// noise of a reading is half the mean square of successive differences, each cut at 12 dB.
/// @param samples  in the order heard
AccessPointBins binned(const std::vector<Sample>& samples, const Position& access_point_in_map,
                       std::optional<double> height_m, const BuildingFrame& frame, double bin_m);

/// Variance of one reading at one place [dB2]: half the mean square of successive differences, each
/// cut at 12 dB; at least 0.3 dB squared.
/// @param samples  of one access point, in the order heard
double readingNoise(const std::vector<Sample>& samples);

/// Distances in space [m], given the squares of those on the floor [m2]: at least 0.3 m, and with
/// the antenna 0.6 m above the floor where the access point's height is known.
Eigen::ArrayXd spaceDistance(const Eigen::ArrayXd& squares_m2, std::optional<double> height_m);

/// 10 log10 of the distance in space in metres, at least 0.3 m: what the path loss exponent is
/// multiplied by. The antenna rides 0.6 m above the floor where the access point's height is known.
double logDistance(const AccessPointBins& access_point, const Position& place);

/// How far walls explain what distance does not: one minus the variance of the signals around a
/// log-distance law with the walls' losses given back, over the variance without; 0 to 1. Its
/// complement is all that is neither: noise, furniture, a wrong place of an access point.
/// @param ray_loss  of each bin of each access point [dB]; access points of fewer than ten bins are
///                  left out
double explainedVariance(const std::vector<AccessPointBins>& heard,
                         const std::vector<std::vector<double>>& ray_loss);

}  // namespace sfw
