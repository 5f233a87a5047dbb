#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

namespace sfw {

/// Finds the floors of a building on which the robot drives, from heights of its antenna.
/// Thread-safe.
class Floors {
 public:
  /// Counts an observation at a height [m].
  void observe(double height_m);

  void clear();

  /// The mean height of each floor, the lowest first. Floors are 2 m apart, and a ramp is none.
  std::vector<double> heights() const;

 private:
  struct Layer {
    std::size_t count = 0;
    double sum_m = 0.0;
  };

  mutable std::mutex mutex_;
  std::map<std::int64_t, Layer> layers_;
  std::size_t count_ = 0;
};

}  // namespace sfw
