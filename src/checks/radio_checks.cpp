#include "checks/radio_checks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace sfw {
namespace {

using Readings = std::vector<Reading>;

struct Moments {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;

  void add(double value) {
    count += 1.0;
    sum += value;
    squares += value * value;
  }
  double mean() const { return count > 0.0 ? sum / count : 0.0; }
  double deviation() const {
    return count > 0.0 ? std::sqrt(std::max(0.0, squares / count - mean() * mean())) : 0.0;
  }
};

Moments momentsOf(const Readings& readings) {
  Moments moments;
  for (const Reading& reading : readings) {
    moments.add(reading.rssi_dbm);
  }
  return moments;
}

/// The differences of two access points' signals at the same stamps.
Moments differencesOf(const Readings& a, const Readings& b) {
  Moments differences;
  std::size_t j = 0;
  for (const Reading& reading : a) {
    while (j < b.size() && b[j].stamp_ns < reading.stamp_ns) {
      ++j;
    }
    if (j < b.size() && b[j].stamp_ns == reading.stamp_ns) {
      differences.add(reading.rssi_dbm - b[j].rssi_dbm);
    }
  }
  return differences;
}

/// Two radios at one place still differ by a few decibels, because their waves interfere otherwise.
bool areOneRadio(const Readings& a, const Readings& b, const Moments& of_a, const Moments& of_b) {
  constexpr double kFewest = 30.0;
  constexpr double kMostCommon = 0.5;  // of the readings of the rarer one
  constexpr double kVaries = 3.0;      // [dB]
  constexpr double kAlike = 0.3;       // of the deviation of the signals
  constexpr double kMostOffset = 3.0;  // [dB]
  const double least = std::min(of_a.deviation(), of_b.deviation());
  if (least < kVaries) {
    return false;
  }
  const Moments differences = differencesOf(a, b);
  return differences.count >= std::max(kFewest, kMostCommon * std::min(of_a.count, of_b.count)) &&
         differences.deviation() < kAlike * least && std::abs(differences.mean()) < kMostOffset;
}

}  // namespace

AliasFinding findAliases(const std::vector<AccessPoint>& table,
                         const std::vector<Readings>& readings) {
  constexpr std::size_t kMostCompared = 10;
  std::vector<Moments> moments;
  for (const Readings& radio : readings) {
    moments.push_back(momentsOf(radio));
  }
  std::vector<std::size_t> by_mean(table.size());
  std::iota(by_mean.begin(), by_mean.end(), std::size_t{0});
  std::stable_sort(by_mean.begin(), by_mean.end(), [&](std::size_t a, std::size_t b) {
    return moments[a].mean() < moments[b].mean();
  });
  AliasFinding finding;
  std::vector<bool> grouped(table.size(), false);
  for (std::size_t i = 0; i < by_mean.size(); ++i) {
    const std::size_t one = by_mean[i];
    std::vector<Bssid> group{table[one].bssid};
    const std::size_t end = std::min(by_mean.size(), i + 1 + kMostCompared);
    for (std::size_t j = i + 1; j < end && !grouped[one]; ++j) {
      const std::size_t other = by_mean[j];
      if (!grouped[other] &&
          areOneRadio(readings[one], readings[other], moments[one], moments[other])) {
        grouped[other] = true;
        group.push_back(table[other].bssid);
      }
    }
    if (group.size() > 1) {
      std::sort(group.begin(), group.end());
      finding.groups.push_back(group);
    }
  }
  std::sort(finding.groups.begin(), finding.groups.end());
  return finding;
}

std::vector<Bssid> findHeardAtOnePlace(const std::vector<AccessPoint>& table,
                                       const std::vector<Readings>& readings,
                                       const std::vector<PathPose>& path) {
  constexpr std::size_t kFewestReadings = 5;
  constexpr double kOnePlace = 1.0;    // [m]
  constexpr double kMuchLonger = 4.0;  // [m]
  Box driven;
  for (const PathPose& pose : path) {
    driven.extend(pose.antenna_in_map);
  }
  std::vector<Bssid> found;
  if (driven.isEmpty() || driven.diagonal().norm() < kMuchLonger) {
    return found;
  }
  for (std::size_t i = 0; i < table.size(); ++i) {
    Box heard;
    for (const Reading& reading : readings[i]) {
      heard.extend(reading.antenna_in_map);
    }
    if (readings[i].size() >= kFewestReadings && heard.diagonal().norm() < kOnePlace) {
      found.push_back(table[i].bssid);
    }
  }
  return found;
}

}  // namespace sfw
