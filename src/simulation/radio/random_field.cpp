#include "simulation/radio/random_field.h"

#include <cmath>

#include "base/constants.h"
#include "base/random.h"

namespace sfw {
namespace {

constexpr std::size_t kWaves = 128;

/// The wave number below which a share of the field's power lies, for length 1: the inverse of the
/// spectrum's radial distribution.
double waveNumber(RandomField::Kind kind, double share) {
  const double rest = 1.0 - share;
  return kind == RandomField::Kind::kRough ? std::sqrt(1.0 / (rest * rest) - 1.0)
                                           : 2.0 * std::sqrt(-std::log(rest));
}

}  // namespace

RandomField::RandomField(Kind kind, double length_m, std::int64_t seed, std::uint64_t stream) {
  const double golden_angle = kPi * (3.0 - std::sqrt(5.0));
  Random random(seed, stream, 0);
  const double first_direction = 2.0 * kPi * random.uniform();
  for (std::size_t i = 0; i < kWaves; ++i) {
    const auto at = static_cast<double>(i);
    // uniform() may be exactly 1. The last share must be less.
    const double share = (at + 1.0 - random.uniform()) / static_cast<double>(kWaves);
    const double direction = first_direction + at * golden_angle;
    const double number = waveNumber(kind, share) / length_m;
    waves_.push_back({number * Position(std::cos(direction), std::sin(direction)),
                      2.0 * kPi * random.uniform()});
  }
}

double RandomField::at(const Position& place) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) {
    sum += std::cos(wave.rad_per_m.dot(place) + wave.phase_rad);
  }
  return std::sqrt(2.0 / static_cast<double>(kWaves)) * sum;
}

}  // namespace sfw
