#include "ros/mapping/floors.h"

#include <cmath>

namespace sfw {

void Floors::observe(double height_m) {
  constexpr double kLayer = 0.5;        // [m]
  constexpr double kHighest = 10000.0;  // [m]
  if (!(std::abs(height_m) < kHighest)) {
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  Layer& layer = layers_[static_cast<std::int64_t>(std::floor(height_m / kLayer))];
  ++layer.count;
  layer.sum_m += height_m;
  ++count_;
}

void Floors::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  layers_.clear();
  count_ = 0;
}

std::vector<double> Floors::heights() const {
  constexpr double kApart = 2.0;       // [m]
  constexpr std::size_t kFewest = 20;  // observations of a floor
  constexpr std::size_t kShare = 40;   // of all observations in a layer, so that lifts are left out
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<double> floors;
  Layer floor;
  double last_m = 0.0;  // mean height of the last layer
  const auto finish = [&] {
    if (floor.count >= kFewest) {
      floors.push_back(floor.sum_m / static_cast<double>(floor.count));
    }
    floor = {};
  };
  for (const auto& [index, layer] : layers_) {
    if (kShare * layer.count < count_) {
      continue;
    }
    const double mean_m = layer.sum_m / static_cast<double>(layer.count);
    if (floor.count > 0 && mean_m - last_m >= kApart) {
      finish();
    }
    floor.count += layer.count;
    floor.sum_m += layer.sum_m;
    last_m = mean_m;
  }
  finish();
  return floors;
}

}  // namespace sfw
