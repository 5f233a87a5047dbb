#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "checks/recording_data.h"
#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// What the checks of a recording examine.
struct CheckedRecording {
  const RecordingData& data;
  const std::vector<AccessPoint>& table;
  const std::vector<PathPose>& path;  ///< of the map: without stray poses, with those between scans
  std::size_t stamped_alike;          ///< as Snapshot::stamped_alike
  double max_gap_m;                   ///< the setting path/max_gap
};

/// Runs all checks that need nothing but the recording. Checks whose result another fault would
/// spoil are left out. O(readings log readings)
RecordingFindings checkRecording(const CheckedRecording& recording);

/// The same finding on units as checkRecording gives, without the other checks.
std::optional<UnitFinding> checkUnits(const CheckedRecording& recording);

/// Whether a fault spoils the whole path: units, stamps, or two places at once.
bool arePosesWrong(const RecordingFindings& findings);

}  // namespace sfw
