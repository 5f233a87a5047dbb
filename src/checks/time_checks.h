#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/reading_refs.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds poses that lie in two places at the same time: the path goes to and fro, each time farther
/// and faster than a robot drives.
/// @param poses         every pose once, by robot and stamp
/// @param step_back_ns  largest step back of the stamps in order of arrival, which explains it
/// O(poses)
std::optional<OverlapFinding> checkOverlap(const std::vector<PathPose>& poses,
                                           std::int64_t step_back_ns);

/// Finds readings that come in bursts, because a driver delivers several at once and late.
/// @param readings  of each access point, by robot and stamp
/// O(readings)
std::optional<BurstFinding> checkBursts(const std::vector<ReadingRefs>& readings);

/// Finds steps of the path that are longer than path/max_gap, if they are a large part of the way.
/// @param path  by robot and stamp
/// O(poses)
std::optional<GapFinding> checkGaps(const std::vector<PathPose>& path, double max_gap_m);

}  // namespace sfw
