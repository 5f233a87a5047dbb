#include "radio/radio_bins.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace sfw {
namespace {

constexpr double kNearest = 0.3;        // [m]
constexpr double kAntennaHeight = 0.6;  // [m], of a robot's antenna when nobody says
constexpr double kLargestStep = 12.0;   // [dB]; larger ones are outliers, not noise
constexpr double kLeastNoise = 0.3;     // [dB]

/// Sum of squares around the log-distance law that fits best, after giving back the losses [dB^2].
double squaresAroundLaw(const AccessPointBins& heard, const std::vector<double>& loss_db) {
  // Exponents measured indoors lie within these, walls counted apart or not.
  constexpr double kLeastExponent = 0.8;
  constexpr double kMostExponent = 3.5;
  const auto count = static_cast<Eigen::Index>(heard.bins.size());
  Eigen::ArrayXd distance(count);
  Eigen::ArrayXd signal(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const RadioBin& bin = heard.bins[static_cast<std::size_t>(i)];
    distance[i] = logDistance(heard, bin.place);
    signal[i] = bin.rssi_dbm + loss_db[static_cast<std::size_t>(i)];
  }
  distance -= distance.mean();
  signal -= signal.mean();
  const double spread = distance.square().sum();
  const double slope = spread > 0.0 ? (distance * signal).sum() / spread : 0.0;
  return (signal - std::clamp(slope, -kMostExponent, -kLeastExponent) * distance).square().sum();
}

}  // namespace

double readingNoise(const std::vector<Sample>& samples) {
  double sum = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step =
        std::min(std::abs(samples[i].rssi_dbm - samples[i - 1].rssi_dbm), kLargestStep);
    sum += 0.5 * step * step;
  }
  const double mean = samples.size() > 1 ? sum / static_cast<double>(samples.size() - 1) : 0.0;
  return std::max(mean, kLeastNoise * kLeastNoise);
}

AccessPointBins binned(const std::vector<Sample>& samples, const Position& access_point_in_map,
                       std::optional<double> height_m, const BuildingFrame& frame, double bin_m) {
  AccessPointBins heard;
  heard.position = frame.toBuilding(access_point_in_map);
  heard.height_m = height_m;
  heard.noise_db2 = readingNoise(samples);
  std::map<std::pair<std::int64_t, std::int64_t>, RadioBin> bins;  // by row, then column
  for (const Sample& sample : samples) {
    const Position place = frame.toBuilding(sample.antenna_in_map);
    RadioBin& bin = bins[{static_cast<std::int64_t>(std::floor(place.y() / bin_m)),
                          static_cast<std::int64_t>(std::floor(place.x() / bin_m))}];
    bin.readings += 1.0;
    bin.place += (place - bin.place) / bin.readings;
    bin.rssi_dbm += (sample.rssi_dbm - bin.rssi_dbm) / bin.readings;
  }
  for (const auto& [key, bin] : bins) {
    if ((bin.place - heard.position).norm() >= kNearest) {
      heard.bins.push_back(bin);
    }
  }
  return heard;
}

Eigen::ArrayXd spaceDistance(const Eigen::ArrayXd& squares_m2, std::optional<double> height_m) {
  const double rise = height_m ? *height_m - kAntennaHeight : 0.0;
  return (squares_m2.max(kNearest * kNearest) + rise * rise).sqrt();
}

double logDistance(const AccessPointBins& access_point, const Position& place) {
  const double on_floor = std::max((place - access_point.position).norm(), kNearest);
  const double distance = access_point.height_m
                              ? std::hypot(on_floor, *access_point.height_m - kAntennaHeight)
                              : on_floor;
  return 10.0 * std::log10(distance);
}

double explainedVariance(const std::vector<AccessPointBins>& heard,
                         const std::vector<std::vector<double>>& ray_loss) {
  constexpr std::size_t kFewest = 10;
  double by_distance = 0.0;
  double with_walls = 0.0;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    if (heard[i].bins.size() >= kFewest) {
      by_distance += squaresAroundLaw(heard[i], std::vector<double>(heard[i].bins.size(), 0.0));
      with_walls += squaresAroundLaw(heard[i], ray_loss[i]);
    }
  }
  return by_distance > 0.0 ? std::clamp(1.0 - with_walls / by_distance, 0.0, 1.0) : 0.0;
}

}  // namespace sfw
