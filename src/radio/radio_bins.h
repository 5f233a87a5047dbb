#pragma once

#include <optional>
#include <vector>

#include "path/building_frame.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The log-distance law ends at this distance; smaller distances count as this one.
constexpr double kNearFieldM = 0.3;

/// Mean of the readings of one access point within one square of the floor.
struct RadioBin {
  Position position = Position::Zero();  ///< mean of the antenna's positions [m], building frame
  double rssi_dbm = 0.0;                 ///< mean
  double readings = 0.0;                 ///< how many, at least 1
};

/// All bins of one access point.
struct AccessPointBins {
  Position position = Position::Zero();  ///< of the access point [m], building frame
  std::optional<double> height_m;        ///< of the access point above the floor
  double noise_db2 = 0.0;                ///< variance of one reading at one position

  /// Covariance of the access point's position [m2], building frame; zero if it is known.
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();

  std::vector<RadioBin> bins;
};

/// Averages the readings of one access point in squares of edge `bin_size_m`.
///
/// Bins closer than kNearFieldM to the access point are dropped.
/// @param samples  by time
/// @param frame    its axes are those of the squares
/// @return the bins in row-major order; their noise is readingNoise(samples).
AccessPointBins binSamples(const std::vector<Sample>& samples, const Position& access_point_in_map,
                           std::optional<double> height_m, const BuildingFrame& frame,
                           double bin_size_m);

/// The index of each sample's bin; the number of bins where its bin was dropped.
/// @param frame,bin_size_m  as for binSamples
std::vector<std::size_t> binsOfSamples(const std::vector<Sample>& samples,
                                       const AccessPointBins& binned, const BuildingFrame& frame,
                                       double bin_size_m);

/// Variance of one reading at one position [dB2]: half the mean square of successive differences,
/// each cut at 12 dB; at least 0.09 dB2.
/// @param samples  of one access point, by time
double readingNoise(const std::vector<Sample>& samples);

/// Positions of the bins [m], building frame, in their order.
std::vector<Position> positionsOf(const AccessPointBins& access_point);

/// Variance of each bin's mean that comes from the noise of single readings [dB2].
std::vector<double> noiseOfMeans(const AccessPointBins& access_point);

}  // namespace sfw
