#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "radio/radio_bins.h"
#include "radio/shadowing.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Possible positions of an access point that are rated at once.
constexpr std::size_t kPositionLanes = 4;

/// Numbers of these positions side by side. The processor calculates with all of them at once.
using PositionLanes = std::array<double, kPositionLanes>;

/// The terms of the signal law in AccessPointLikelihood without the first one, which is one
/// everywhere: path loss, distance, and the first and second harmonic of the bearing.
constexpr std::size_t kLawTerms = 6;

/// The terms at one bin.
using LawTerms = std::array<PositionLanes, kLawTerms>;

/// Calculates the terms of the law at all bins of an access point.
class LawTermsAtBins {
 public:
  explicit LawTermsAtBins(const AccessPointBins& access_point);

  /// Sets the terms for four positions [m] of the access point.
  /// @param terms  set to one item for each bin
  void at(const std::array<Position, kPositionLanes>& positions,
          std::vector<LawTerms>& terms) const;

 private:
  std::vector<double> x_, y_;  // of the bins [m]
  double rise_m_;              // from the antenna to the access point
  double usual_rise_m_;        // more of it, where the height is unknown
};

/// Products of whitened terms and signals, summed over the bins.
using LawProducts = Eigen::Matrix<double, kLawTerms + 2, kLawTerms + 2>;

/// Whitens the terms of four positions and multiplies them with each other.
/// @param terms          of each bin
/// @param white_ones     the law's first term, whitened
/// @param white_signals  the bins' signals, whitened
/// @param white          only its memory is used
/// @return for each position the products of: the first term, the others, and the signals
/// O(bins).
std::array<LawProducts, kPositionLanes> productsOf(const std::vector<LawTerms>& terms,
                                                   const ShadowingWhitener& whitener,
                                                   const Eigen::VectorXd& white_ones,
                                                   const Eigen::VectorXd& white_signals,
                                                   std::vector<LawTerms>& white);

}  // namespace sfw
