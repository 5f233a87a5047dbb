#include "training/disturbance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/constants.h"
#include "base/random.h"
#include "base/random_streams.h"

namespace sfw {
namespace {

constexpr double kStrongest = -1.0;  // [dBm]
constexpr double kWeakest = -119.0;  // [dBm]

double limited(double rssi_dbm) { return std::clamp(rssi_dbm, kWeakest, kStrongest); }

bool happens(double probability, Random& random) { return random.uniform() <= probability; }

/// The readings of one access point, in the order of time.
using Series = std::vector<Reading*>;

void displaceAccessPoints(std::vector<AccessPoint>& access_points, bool clean, Random& random) {
  if (happens(clean ? 0.7 : 0.4, random)) {
    return;
  }
  const double axis_m = random.uniform(0.15, 0.5) / std::sqrt(2.0);
  for (AccessPoint& access_point : access_points) {
    access_point.position += axis_m * Position(random.normal(), random.normal());
  }
}

void addNoise(std::vector<Reading>& readings, Random& random) {
  const double noise_db = happens(0.6, random) ? 0.0 : random.uniform(0.0, 2.0);
  const double outliers = happens(0.5, random) ? 0.01 : 0.04;
  for (Reading& reading : readings) {
    if (happens(outliers, random)) {
      reading.rssi_dbm -= random.uniform(0.0, 10.0);
    }
    reading.rssi_dbm = limited(reading.rssi_dbm + noise_db * random.normal());
  }
}

void shiftAlongPath(const Series& series, Random& random) {
  std::vector<double> shifted(series.size());
  const auto by =
      static_cast<std::size_t>(random.uniform(0.15, 0.85) * static_cast<double>(series.size()));
  for (std::size_t i = 0; i < series.size(); ++i) {
    shifted[i] = series[(i + by) % series.size()]->rssi_dbm;
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    series[i]->rssi_dbm = shifted[i];
  }
}

/// Replaces each signal by the mean over some readings before and after it.
void average(const Series& series, std::size_t reach) {
  std::vector<double> sums{0.0};
  for (const Reading* reading : series) {
    sums.push_back(sums.back() + reading->rssi_dbm);
  }
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::size_t first = i - std::min(i, reach);
    const std::size_t end = std::min(series.size(), i + reach + 1);
    series[i]->rssi_dbm = (sums[end] - sums[first]) / static_cast<double>(end - first);
  }
}

/// Adds a sum of waves with random directions: a Gaussian field with a Gaussian covariance.
void addField(const Series& series, double amplitude_db, double length_m, Random& random) {
  struct Wave {
    Position number;  // [rad/m]
    double phase;
  };
  std::array<Wave, 12> waves;
  for (Wave& wave : waves) {
    wave = {Position(random.normal(), random.normal()) / length_m, random.uniform(0.0, 2.0 * kPi)};
  }
  const double scale = amplitude_db / std::sqrt(0.5 * static_cast<double>(waves.size()));
  for (Reading* reading : series) {
    for (const Wave& wave : waves) {
      reading->rssi_dbm += scale * std::cos(wave.number.dot(reading->antenna_in_map) + wave.phase);
    }
    reading->rssi_dbm = limited(reading->rssi_dbm);
  }
}

}  // namespace

void disturb(TrainingDrive& drive, const NoiseLevel& noise, std::int64_t seed) {
  const bool clean = noise.name == "none" || noise.name == "low";
  Random random(seed, streamOf(Purpose::kDisturbance), 0);
  displaceAccessPoints(drive.access_points, clean, random);
  if (!clean) {
    addNoise(drive.readings, random);
  }
  const bool averages = happens(0.2, random);
  const auto reach = static_cast<std::size_t>(random.uniform(2.0, 32.0));
  const bool has_field = !clean && happens(0.2, random);
  const double amplitude_db = random.uniform(1.5, 4.0);
  const double length_m = random.uniform(0.6, 1.8);
  const bool shifted = !clean && happens(0.15, random);
  std::map<Bssid, Series> by_access_point;
  for (Reading& reading : drive.readings) {
    by_access_point[reading.bssid].push_back(&reading);
  }
  for (const auto& [bssid, series] : by_access_point) {
    if (shifted) {
      shiftAlongPath(series, random);
    }
    if (averages) {
      average(series, reach);
    }
    if (has_field) {
      addField(series, amplitude_db, length_m, random);
    }
  }
}

}  // namespace sfw
