#include "localization/signal_bins.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "radio/path_loss.h"

namespace sfw {
namespace {

constexpr double kConstantMeanDbm = -75.0;

double logDistance(const Position& source, const Position& position) {
  // An antenna and an access point are seldom nearer, in space, than a metre.
  return 5.0 * std::log10((position - source).squaredNorm() + 1.0);
}

}  // namespace

SignalBins signalBins(const std::vector<Sample>& samples) {
  constexpr double kBinSizeM = 0.5;
  constexpr std::size_t kMostBins = 250;
  constexpr double kUsualDb2 = 6.0;
  constexpr double kWeightOfUsual = 4.0;
  std::vector<Sample> sorted = samples;
  std::sort(sorted.begin(), sorted.end(), [](const Sample& a, const Sample& b) {
    return std::make_tuple(a.antenna_in_map.x(), a.antenna_in_map.y(), a.rssi_dbm) <
           std::make_tuple(b.antenna_in_map.x(), b.antenna_in_map.y(), b.rssi_dbm);
  });
  std::map<std::pair<double, double>, RadioBin> bins;
  double squares = 0.0;
  double size_m = kBinSizeM;
  do {
    bins.clear();
    squares = 0.0;
    for (const Sample& sample : sorted) {
      RadioBin& bin = bins[{std::floor(sample.antenna_in_map.y() / size_m),
                            std::floor(sample.antenna_in_map.x() / size_m)}];
      const double before = sample.rssi_dbm - bin.rssi_dbm;
      bin.readings += 1.0;
      bin.position += (sample.antenna_in_map - bin.position) / bin.readings;
      bin.rssi_dbm += before / bin.readings;
      squares += before * (sample.rssi_dbm - bin.rssi_dbm) * (bin.readings > 1.0 ? 1.0 : 0.0);
    }
    size_m *= 1.25;
  } while (bins.size() > kMostBins);
  SignalBins result;
  result.noise_db2 = (squares + kWeightOfUsual * kUsualDb2) /
                     (static_cast<double>(samples.size() - bins.size()) + kWeightOfUsual);
  for (const auto& [square, bin] : bins) {
    result.positions.push_back(bin.position);
    result.rssi_dbm.push_back(bin.rssi_dbm);
    result.readings.push_back(bin.readings);
  }
  return result;
}

double priorMean(const SignalLaw& law, const Position& position) {
  if (!law.source) {
    return kConstantMeanDbm;
  }
  return kPriorPowerDbm - kPriorExponent * logDistance(*law.source, position);
}

Eigen::Vector2d signalBasis(const SignalLaw& law, const Position& position) {
  const double exponent =
      law.source ? -law.covariance.exponent_sd * logDistance(*law.source, position) : 0.0;
  return {law.covariance.power_sd_db, exponent};
}

}  // namespace sfw
