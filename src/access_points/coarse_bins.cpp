#include "access_points/coarse_bins.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace sfw {
namespace {

constexpr double kBinSizeM = 0.4;
constexpr std::size_t kMostBins = 300;
constexpr double kLeastNoiseDb2 = 0.1;

/// Row and column of a square of the floor.
using Square = std::pair<std::int64_t, std::int64_t>;
using SamplesBySquare = std::map<Square, std::vector<Sample>>;  // by row, then column

/// The samples of each square, or nothing if there are too many squares.
std::optional<SamplesBySquare> bySquare(const std::vector<Sample>& samples, double edge_m) {
  SamplesBySquare all;
  Square last;
  std::vector<Sample>* found = nullptr;
  for (const Sample& sample : samples) {
    const Square square{static_cast<std::int64_t>(std::floor(sample.antenna_in_map.y() / edge_m)),
                        static_cast<std::int64_t>(std::floor(sample.antenna_in_map.x() / edge_m))};
    if (found == nullptr || square != last) {  // most samples lie where the one before lies
      found = &all[square];
      last = square;
      if (all.size() > kMostBins) {
        return std::nullopt;
      }
    }
    found->push_back(sample);
  }
  return all;
}

/// In an order that does not depend on time.
void sort(std::vector<Sample>& samples) {
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return std::make_tuple(a.antenna_in_map.x(), a.antenna_in_map.y(), a.rssi_dbm) <
           std::make_tuple(b.antenna_in_map.x(), b.antenna_in_map.y(), b.rssi_dbm);
  });
}

RadioBin meanOf(const std::vector<Sample>& samples) {
  RadioBin bin;
  for (const Sample& sample : samples) {
    bin.readings += 1.0;
    bin.position += (sample.antenna_in_map - bin.position) / bin.readings;
    bin.rssi_dbm += (sample.rssi_dbm - bin.rssi_dbm) / bin.readings;
  }
  return bin;
}

}  // namespace

AccessPointBins coarseBins(const std::vector<Sample>& samples, std::optional<double> height_m) {
  constexpr double kLarger = 1.25;
  constexpr double kUsualDb2 = 9.0;
  constexpr double kReadings = 2.0;          // weight of the usual noise, as a number of readings
  constexpr double kUsualSignalDbm = -60.0;  // subtracted first: squares of large numbers round
  double edge_m = kBinSizeM;
  std::optional<SamplesBySquare> squares = bySquare(samples, edge_m);
  while (!squares) {
    edge_m *= kLarger;
    squares = bySquare(samples, edge_m);
  }
  AccessPointBins binned;
  binned.height_m = height_m;
  const auto square_of = [](double rssi_dbm) {
    return (rssi_dbm - kUsualSignalDbm) * (rssi_dbm - kUsualSignalDbm);
  };
  double sum = kReadings * kUsualDb2;
  for (auto& [square, in_square] : *squares) {
    sort(in_square);
    for (const Sample& sample : in_square) {
      sum += square_of(sample.rssi_dbm);
    }
    binned.bins.push_back(meanOf(in_square));
  }
  for (const RadioBin& bin : binned.bins) {
    sum -= bin.readings * square_of(bin.rssi_dbm);
  }
  const double freedom = static_cast<double>(samples.size() - binned.bins.size()) + kReadings;
  binned.noise_db2 = std::max(kLeastNoiseDb2, sum / freedom);
  return binned;
}

}  // namespace sfw
