#pragma once

#include <optional>
#include <vector>

#include "base/reading_refs.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds access points whose signals are no dBm, because the mapper refuses most of them.
/// @param table     the access points
/// @param accepted  signals of each access point that the mapper accepts
/// @param refused   signals of each access point that it refuses
/// O(readings)
std::optional<SignalUnitFinding> checkSignalUnit(const std::vector<AccessPoint>& table,
                                                 const std::vector<ReadingRefs>& accepted,
                                                 const std::vector<ReadingRefs>& refused);

/// Finds access points whose signals are repeated from a cache while the robot drives.
///
/// At least .45 of the signals that follow each other are then equal, and the others differ by much
/// more than the radio's resolution. Signals without noise also repeat, but change by one step.
/// @param readings  of each access point, by stamp
/// O(readings)
std::optional<CachedFinding> checkCachedSignals(const std::vector<AccessPoint>& table,
                                                const std::vector<ReadingRefs>& readings);

}  // namespace sfw
