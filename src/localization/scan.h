#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// What was heard within a short time: each BSSID once.
struct Scan {
  std::int64_t stamp_ns = 0;                    ///< of its first reading
  Position position = Position::Zero();         ///< mean of its readings' positions [m], map frame
  std::vector<std::pair<Bssid, double>> heard;  ///< mean RSSI [dBm] of each BSSID, by BSSID
  std::vector<Bssid> repeated;                  ///< left out by withoutRepeated, by BSSID
};

/// Groups readings into scans.
///
/// A scan starts with the first reading that is more than `window_ns` later than the start of the
/// scan before it, or of another robot.
/// @param readings in any order
/// @return the scans by robot and time. O(readings log readings).
std::vector<Scan> scansOf(std::vector<Reading> readings, std::int64_t window_ns);

/// Groups readings into stretches of the way, each as one scan.
///
/// A stretch starts with the first reading that is farther than `length_m` from the start of the
/// stretch before it, or of another robot.
/// @param readings in any order
/// @return the stretches by robot and time. O(readings log readings).
std::vector<Scan> stretchesOf(std::vector<Reading> readings, double length_m);

/// Leaves out values that a driver repeats from its cache: they tell of the place before.
///
/// A scan repeats if at least five BSSIDs, and two in five of those that the scan before heard too,
/// have exactly the values of that scan. They move from `heard` to `repeated`.
Scan withoutRepeated(const Scan& scan, const Scan& before);

/// Lengths of the straight steps from each scan to the next, summed up [m]; 0 for the first scan.
std::vector<double> wayOf(const std::vector<Scan>& scans);

}  // namespace sfw
