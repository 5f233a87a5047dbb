#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>

#include "ros/mapping/localization.h"

namespace sfw {

/// The time from the start of one map update to the start of the next [s].
/// @param rate_hz    upper limit of updates
/// @param cpu_share  of one core that updates may take
/// @param cpu_s      CPU time of the last update
inline double updatePeriod(double rate_hz, double cpu_share, double cpu_s) {
  return std::max(1.0 / rate_hz, cpu_s / cpu_share);
}

/// Decides which observations are worth a new map.
///
/// Readings of one access point in one square count as one bin, so a robot that stands still adds
/// next to nothing. The first five readings of each bin are news, and the first contact in each
/// square of a quarter of its edge: a robot that presses against a wall must learn of it. Others
/// are kept, and wait for the next news. Not thread-safe.
class RefreshRule {
 public:
  /// @param bin_size_m  edge of a square
  explicit RefreshRule(double bin_size_m) : bin_size_m_(bin_size_m) {}

  /// Whether an observation is news. It is counted in any case.
  bool isNews(const LocatedObservation& observation);

  /// Forgets all observations.
  void clear() { seen_.clear(); }

 private:
  /// Whether fewer than `most` observations came before from this bin.
  bool isNew(const Bssid& bssid, const Position& position, double bin_size_m, int most);

  double bin_size_m_;
  std::map<std::tuple<Bssid, std::int64_t, std::int64_t>, int> seen_;
};

}  // namespace sfw
