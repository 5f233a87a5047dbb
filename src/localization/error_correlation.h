#pragma once

#include <Eigen/Core>
#include <atomic>
#include <vector>

#include "localization/mapped_radio.h"
#include "localization/scan.h"

namespace sfw {

/// Correlation of the errors of each two radios in one scan, where their block was held out.
///
/// Several BSSIDs of one radio err alike, so they are not independent witnesses. Correlations below
/// two standard errors count as 0: chance would add up over many radios. Few common scans shrink
/// the others.
/// @param folds of each scan, as of foldsOf
/// @param stop  once it is true, the other radios correlate with none; may be nullptr
/// @return radios x radios, in 0..1, with 1 on the diagonal.
/// Uses at most 2000 scans, evenly spread. O(radios^2 x scans).
Eigen::MatrixXf errorCorrelation(const std::vector<MappedRadio>& radios,
                                 const std::vector<Scan>& scans, const std::vector<int>& folds,
                                 const std::atomic<bool>* stop);

}  // namespace sfw
