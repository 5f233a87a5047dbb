#include "radio/path_loss.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

constexpr double kAntennaHeightM = 0.6;  // of a robot's antenna; no setting gives it

/// Sum of squared residuals of the best log-distance law after the losses are added back [dB2].
double squaresAroundLaw(const AccessPointBins& access_point, const std::vector<double>& loss_db) {
  // Exponents measured indoors lie within these limits, with or without separate walls.
  constexpr double kLeastExponent = 0.8;
  constexpr double kMostExponent = 3.5;
  const auto count = static_cast<Eigen::Index>(access_point.bins.size());
  Eigen::ArrayXd distance(count);
  Eigen::ArrayXd signal(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const RadioBin& bin = access_point.bins[static_cast<std::size_t>(i)];
    distance[i] = logDistance(access_point, bin.position);
    signal[i] = bin.rssi_dbm + loss_db[static_cast<std::size_t>(i)];
  }
  distance -= distance.mean();
  signal -= signal.mean();
  const double spread = distance.square().sum();
  const double slope = spread > 0.0 ? (distance * signal).sum() / spread : 0.0;
  return (signal - std::clamp(slope, -kMostExponent, -kLeastExponent) * distance).square().sum();
}

}  // namespace

double antennaToAccessPoint(std::optional<double> height_m) {
  return height_m ? *height_m - kAntennaHeightM : 0.0;
}

double logDistance(const AccessPointBins& access_point, const Position& antenna) {
  const double on_floor = std::max((antenna - access_point.position).norm(), kNearFieldM);
  const double distance = access_point.height_m
                              ? std::hypot(on_floor, antennaToAccessPoint(access_point.height_m))
                              : on_floor;
  return 10.0 * std::log10(distance);
}

double explainedVariance(const std::vector<AccessPointBins>& access_points,
                         const std::vector<std::vector<double>>& ray_loss_db) {
  constexpr std::size_t kFewestBins = 10;
  double by_distance = 0.0;
  double with_walls = 0.0;
  for (std::size_t i = 0; i < access_points.size(); ++i) {
    const std::size_t bins = access_points[i].bins.size();
    if (bins >= kFewestBins) {
      by_distance += squaresAroundLaw(access_points[i], std::vector<double>(bins, 0.0));
      with_walls += squaresAroundLaw(access_points[i], ray_loss_db[i]);
    }
  }
  return by_distance > 0.0 ? std::clamp(1.0 - with_walls / by_distance, 0.0, 1.0) : 0.0;
}

}  // namespace sfw
