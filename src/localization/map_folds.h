#pragma once

#include <vector>

#include "localization/scan.h"

namespace sfw {

/// Blocks of the mapped way by turns: 0 or 1 for each scan. There are at least four blocks.
/// @param scans by time, not empty
std::vector<int> foldsOf(const std::vector<Scan>& scans, double block_m);

/// Root mean square distance of the scans of each fold to the nearest of the other [m]: how far
/// from a mapped path the same robot is met. Distances count as at most 4 m.
double distanceBetweenFolds(const std::vector<Scan>& scans, const std::vector<int>& folds);

}  // namespace sfw
