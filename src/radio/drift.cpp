#include "radio/drift.h"

#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

constexpr double kStretch = 0.25;  // [m] of way
constexpr double kMostStretches = 2000.0;
constexpr double kReturn = 10.0;  // [m] of way, so that there is time to drift
constexpr double kHere = 0.3;     // [m]
constexpr double kNearby = 2.0;   // [m], to kNoFarther: beyond most shadows, yet much the same room
constexpr double kNoFarther = 3.0;

constexpr std::size_t kFewestReturns = 20;
constexpr double kLeastChange = 4.0;    // [dB2]
constexpr double kLargestStep = 15.0;   // [dB]; one outlier must not decide
constexpr double kSuspectRatio = 0.55;  // chosen on simulated drives (doc/results/ablations.md)

/// A short stretch of way and what was heard on it.
struct Stretch {
  Position place = Position::Zero();  // mean [m]
  double rssi_dbm = 0.0;              // mean
  double readings = 0.0;
  double driven_m = 0.0;  // until it begins
};

/// The way driven until each sample [m]. Poses of a robot that stands jitter: that is no way.
std::vector<double> wayUntil(const std::vector<Sample>& samples) {
  constexpr double kLeastStep = 0.1;  // [m]
  std::vector<double> way(samples.size(), 0.0);
  std::size_t last = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step = (samples[i].antenna_in_map - samples[last].antenna_in_map).norm();
    way[i] = way[i - 1];
    if (step >= kLeastStep) {
      way[i] += step;
      last = i;
    }
  }
  return way;
}

std::vector<Stretch> stretchesOf(const std::vector<Sample>& samples) {
  const std::vector<double> way = wayUntil(samples);
  const double longest = std::max(kStretch, way.empty() ? 0.0 : way.back() / kMostStretches);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (stretches.empty() || way[i] >= stretches.back().driven_m + longest) {
      stretches.push_back({Position::Zero(), 0.0, 0.0, way[i]});
    }
    Stretch& stretch = stretches.back();
    stretch.readings += 1.0;
    stretch.place += (samples[i].antenna_in_map - stretch.place) / stretch.readings;
    stretch.rssi_dbm += (samples[i].rssi_dbm - stretch.rssi_dbm) / stretch.readings;
  }
  return stretches;
}

struct Mean {
  double sum = 0.0;
  double count = 0.0;

  void add(double value) {
    sum += value;
    count += 1.0;
  }
  double value() const { return count > 0.0 ? sum / count : 0.0; }
};

/// Squared differences between passes, less what noise makes of them [dB2].
struct Differences {
  Mean here;
  Mean nearby;
  std::size_t returns = 0;
};

void add(const std::vector<Sample>& samples, Differences& differences) {
  const double noise = readingNoise(samples);
  const std::vector<Stretch> stretches = stretchesOf(samples);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& later = stretches[i];
    bool returned = false;
    for (std::size_t j = 0; j < i; ++j) {
      const Stretch& earlier = stretches[j];
      if (later.driven_m - earlier.driven_m < kReturn) {
        break;
      }
      const double distance = (later.place - earlier.place).norm();
      const bool here = distance < kHere;
      if (here || (distance >= kNearby && distance < kNoFarther)) {
        const double step = std::min(std::abs(later.rssi_dbm - earlier.rssi_dbm), kLargestStep);
        (here ? differences.here : differences.nearby)
            .add(step * step - noise * (1.0 / later.readings + 1.0 / earlier.readings));
        returned = returned || here;
      }
    }
    differences.returns += returned ? 1 : 0;
  }
}

}  // namespace

std::optional<DriftCheck> checkDrift(const std::vector<std::vector<Sample>>& samples) {
  Differences differences;
  for (const std::vector<Sample>& of_one : samples) {
    add(of_one, differences);
  }
  if (differences.returns < kFewestReturns || differences.nearby.value() < kLeastChange) {
    return std::nullopt;
  }
  DriftCheck check;
  check.ratio = std::max(0.0, differences.here.value() / differences.nearby.value());
  check.returns = differences.returns;
  check.suspect = check.ratio > kSuspectRatio;
  return check;
}

}  // namespace sfw
