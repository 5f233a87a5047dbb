#pragma once

#include <optional>
#include <vector>

#include "base/reading_refs.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds the values that stand for "not heard" among signals.
///
/// Such a value is exactly the same each time, is repeated regardless of the place, and lies far
/// from all others, or far from the signals around the robot (doc/method/checks.md). A value that
/// one access point has is looked for among the others too.
/// @param table     the access points
/// @param readings  of each access point, by stamp, with signals that the mapper accepts
/// @param refused   of each access point, with signals that it refuses
/// O(readings log readings)
std::vector<SentinelFinding> findSentinels(const std::vector<AccessPoint>& table,
                                           const std::vector<ReadingRefs>& readings,
                                           const std::vector<ReadingRefs>& refused);

/// Whether a reading of a radio has such a value.
bool isSentinel(const std::vector<SentinelFinding>& sentinels, const Bssid& bssid, double rssi_dbm);

}  // namespace sfw
