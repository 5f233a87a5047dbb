#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radio/radio_bins.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Averages the readings of one access point, whose position is unknown, in 300 squares at most.
///
/// The squares have an edge of 0.4 m or more, along the axes of the map. The order of the readings
/// does not matter, so no noise is taken from successive ones: it is the variance within the bins.
/// @return the bins in row-major order; the position of the access point is not set. O(n log n)
AccessPointBins coarseBins(const std::vector<Sample>& samples, std::optional<double> height_m);

}  // namespace sfw
