#pragma once

#include <cmath>
#include <cstdint>

#include "base/constants.h"

namespace sfw {

/// Random numbers by SplitMix64 (Steele et al. 2014) and Box-Muller.
///
/// They are the same on every machine up to the last bit of its mathematical library, unlike those
/// of std::normal_distribution. Each purpose and item has its own generator, so no value depends on
/// the number of values drawn before.
class Random {
 public:
  /// @param seed    of the whole simulation
  /// @param stream  a number for each purpose
  /// @param item    a number for each item of a purpose
  Random(std::int64_t seed, std::uint64_t stream, std::uint64_t item)
      : state_(scrambled(scrambled(static_cast<std::uint64_t>(seed) + kStep * stream) + item)) {}

  /// A uniform variate in (0, 1].
  double uniform() {
    state_ += kStep;
    return static_cast<double>((scrambled(state_) >> 11) + 1) * 0x1p-53;
  }

  /// A uniform variate in (low, high].
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// A normal variate of mean 0 and standard deviation 1.
  double normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * kPi * uniform());
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;

  static std::uint64_t scrambled(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
    return bits ^ (bits >> 31);
  }

  std::uint64_t state_;
};

}  // namespace sfw
