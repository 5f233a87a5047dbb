#pragma once

#include <cstddef>
#include <vector>

#include "mapping/inliers.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The radios of a table of BSSIDs.
struct JoinedRadios {
  /// Index of the BSSID that stands for the radio of each BSSID: its own if it stands for itself.
  std::vector<std::size_t> radio_of;
  std::vector<std::vector<Bssid>> groups;  ///< of two or more BSSIDs, as groupByRadio finds them
};

/// Joins the readings of the BSSIDs that one radio sends, so that each radio is one witness.
///
/// The BSSID with a position, or else with the most readings, stands for the radio. It gets the
/// mean of the signals at each pose, after a constant difference of power is taken from them. The
/// other BSSIDs of the radio have no readings after that.
JoinedRadios joinRadios(const std::vector<AccessPoint>& table, Inliers& inliers);

}  // namespace sfw
