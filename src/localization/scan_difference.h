#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "localization/scan.h"

namespace sfw {

/// How much scans differ by what they hear.
///
/// The difference of two scans is the mean square of the differences of the radios that either
/// hears [dB2]. A radio that is not heard counts as a little weaker than it ever is.
class ScanDifference {
 public:
  /// Radios in fewer than five scans are left out. O(scans x radios).
  explicit ScanDifference(const std::vector<Scan>& scans);

  /// How many radios it compares.
  std::size_t radios() const { return static_cast<std::size_t>(rssi_dbm_.rows()); }

  /// Infinite if the scans have fewer than three radios together, or fewer than all if there are
  /// fewer than three.
  double between(std::size_t a, std::size_t b) const;

  /// The difference which a fifth of the neighbouring scans exceed: those 0.5 to 1.5 m apart
  /// within 5 m of way. 0 if there are fewer than 20.
  /// @param scans  those of the constructor, by time
  double usualOfNeighbours(const std::vector<Scan>& scans) const;

 private:
  Eigen::ArrayXXf rssi_dbm_;                                     // radios x scans
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> is_heard_;  // likewise
};

}  // namespace sfw
