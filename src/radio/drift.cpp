#include "radio/drift.h"

#include <algorithm>
#include <cmath>

#include "radio/radio_bins.h"

namespace sfw {
namespace {

constexpr double kStretchM = 0.25;  // of driving
constexpr double kMostStretches = 2000.0;
constexpr double kReturnM = 10.0;  // of driving between two passes, so that poses can drift
constexpr double kHereM = 0.3;
// Farther than most shadow fading reaches, but mostly in the same room.
constexpr double kNearbyM = 2.0;
constexpr double kNoFartherM = 3.0;

constexpr std::size_t kFewestReturns = 20;
constexpr double kLeastChangeDb2 = 4.0;
constexpr double kLargestStepDb = 15.0;  // one outlier must not decide the result
constexpr double kSuspectRatio = 0.55;   // chosen on simulated drives (doc/results/ablations.md)

/// A short stretch of the path with the mean of its readings.
struct Stretch {
  Position position = Position::Zero();  // mean [m]
  double rssi_dbm = 0.0;                 // mean
  double readings = 0.0;
  double driven_m = 0.0;  // up to its beginning
};

/// Distance driven until each sample [m]. Steps below 0.1 m are skipped, because the poses of a
/// standing robot jitter.
std::vector<double> distanceDriven(const std::vector<Sample>& samples) {
  constexpr double kLeastStepM = 0.1;
  std::vector<double> way(samples.size(), 0.0);
  std::size_t last = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step = (samples[i].antenna_in_map - samples[last].antenna_in_map).norm();
    way[i] = way[i - 1];
    if (step >= kLeastStepM) {
      way[i] += step;
      last = i;
    }
  }
  return way;
}

std::vector<Stretch> cutIntoStretches(const std::vector<Sample>& samples) {
  const std::vector<double> way = distanceDriven(samples);
  const double longest = std::max(kStretchM, way.empty() ? 0.0 : way.back() / kMostStretches);
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (stretches.empty() || way[i] >= stretches.back().driven_m + longest) {
      stretches.push_back({Position::Zero(), 0.0, 0.0, way[i]});
    }
    Stretch& stretch = stretches.back();
    stretch.readings += 1.0;
    stretch.position += (samples[i].antenna_in_map - stretch.position) / stretch.readings;
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

/// Squared differences between passes, without the part of noise [dB2].
struct Differences {
  Mean here;
  Mean nearby;
  std::size_t returns = 0;
};

void add(const std::vector<Sample>& samples, Differences& differences) {
  const double noise = readingNoise(samples);
  const std::vector<Stretch> stretches = cutIntoStretches(samples);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& later = stretches[i];
    bool returned = false;
    for (std::size_t j = 0; j < i; ++j) {
      const Stretch& earlier = stretches[j];
      if (later.driven_m - earlier.driven_m < kReturnM) {
        break;
      }
      const double distance = (later.position - earlier.position).norm();
      const bool here = distance < kHereM;
      if (here || (distance >= kNearbyM && distance < kNoFartherM)) {
        const double step = std::min(std::abs(later.rssi_dbm - earlier.rssi_dbm), kLargestStepDb);
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
  for (const std::vector<Sample>& access_point : samples) {
    add(access_point, differences);
  }
  if (differences.returns < kFewestReturns || differences.nearby.value() < kLeastChangeDb2) {
    return std::nullopt;
  }
  DriftCheck check;
  check.ratio = std::max(0.0, differences.here.value() / differences.nearby.value());
  check.returns = differences.returns;
  check.suspect = check.ratio > kSuspectRatio;
  return check;
}

}  // namespace sfw
