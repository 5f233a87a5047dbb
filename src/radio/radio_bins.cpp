#include "radio/radio_bins.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <type_traits>
#include <utility>

namespace sfw {
namespace {

/// Row and column of a square of the floor.
using Square = std::pair<std::int64_t, std::int64_t>;

/// The largest whole number that is not larger. Unlike std::floor, it is no call of a library.
std::int64_t wholeBelow(double value) {
  const auto whole = static_cast<std::int64_t>(value);
  return whole - (static_cast<double>(whole) > value ? 1 : 0);
}

/// @param position  [m], building frame
Square squareAt(const Position& position, double bin_size_m) {
  return {wholeBelow(position.y() / bin_size_m), wholeBelow(position.x() / bin_size_m)};
}

/// Finds the items of samples in a map by squares. Most samples lie in the square of the one before
/// them, so most searches are short.
template <class Find>
class SquareSearch {
 public:
  explicit SquareSearch(Find find) : find_(find) {}

  auto& operator()(const Square& square) {
    if (found_ == nullptr || square != last_) {
      found_ = &find_(square);
      last_ = square;
    }
    return *found_;
  }

 private:
  Find find_;
  Square last_;
  std::remove_reference_t<std::invoke_result_t<Find, Square>>* found_ = nullptr;
};

}  // namespace

double readingNoise(const std::vector<Sample>& samples) {
  constexpr double kLargestStepDb = 12.0;  // larger ones are outliers, not noise
  constexpr double kLeastNoiseDb = 0.3;
  double sum = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step =
        std::min(std::abs(samples[i].rssi_dbm - samples[i - 1].rssi_dbm), kLargestStepDb);
    sum += 0.5 * step * step;
  }
  const double mean = samples.size() > 1 ? sum / static_cast<double>(samples.size() - 1) : 0.0;
  return std::max(mean, kLeastNoiseDb * kLeastNoiseDb);
}

AccessPointBins binSamples(const std::vector<Sample>& samples, const Position& access_point_in_map,
                           std::optional<double> height_m, const BuildingFrame& frame,
                           double bin_size_m) {
  AccessPointBins binned;
  binned.position = frame.toBuilding(access_point_in_map);
  binned.height_m = height_m;
  binned.noise_db2 = readingNoise(samples);
  std::map<Square, RadioBin> bins;  // by row, then column
  const Eigen::Matrix2d to_building = frame.toBuildingAxes();
  SquareSearch binAt([&](const Square& square) -> RadioBin& { return bins[square]; });
  for (const Sample& sample : samples) {
    const Position position = to_building * sample.antenna_in_map;
    RadioBin& bin = binAt(squareAt(position, bin_size_m));
    bin.readings += 1.0;
    bin.position += (position - bin.position) / bin.readings;
    bin.rssi_dbm += (sample.rssi_dbm - bin.rssi_dbm) / bin.readings;
  }
  for (const auto& [key, bin] : bins) {
    if ((bin.position - binned.position).norm() >= kNearFieldM) {
      binned.bins.push_back(bin);
    }
  }
  return binned;
}

std::vector<std::size_t> binsOfSamples(const std::vector<Sample>& samples,
                                       const AccessPointBins& binned, const BuildingFrame& frame,
                                       double bin_size_m) {
  std::map<Square, std::size_t> index;
  for (std::size_t i = 0; i < binned.bins.size(); ++i) {
    index.emplace(squareAt(binned.bins[i].position, bin_size_m), i);
  }
  const std::size_t none = binned.bins.size();
  SquareSearch indexAt([&](const Square& square) -> const std::size_t& {
    const auto found = index.find(square);
    return found == index.end() ? none : found->second;
  });
  const Eigen::Matrix2d to_building = frame.toBuildingAxes();
  std::vector<std::size_t> bin_of;
  bin_of.reserve(samples.size());
  for (const Sample& sample : samples) {
    bin_of.push_back(indexAt(squareAt(to_building * sample.antenna_in_map, bin_size_m)));
  }
  return bin_of;
}

std::vector<Position> positionsOf(const AccessPointBins& access_point) {
  std::vector<Position> positions;
  positions.reserve(access_point.bins.size());
  for (const RadioBin& bin : access_point.bins) {
    positions.push_back(bin.position);
  }
  return positions;
}

std::vector<double> noiseOfMeans(const AccessPointBins& access_point) {
  std::vector<double> noise_db2;
  noise_db2.reserve(access_point.bins.size());
  for (const RadioBin& bin : access_point.bins) {
    noise_db2.push_back(access_point.noise_db2 / bin.readings);
  }
  return noise_db2;
}

}  // namespace sfw
