#pragma once

#include <cstddef>
#include <vector>

#include "localization/place_lattice.h"
#include "localization/radio_layers.h"

namespace sfw {

/// Exponents of the two parts of a scan's evidence. Readings of one scan share errors that no
/// pairwise correlation shows, so their plain sum may say too much, or too little.
struct Temper {
  double signal = 0.5;
  double heard = 0.1;

  /// Tempered log likelihood of each place.
  std::vector<double> applied(const ScanEvidence& evidence) const;
};

/// A held-out scan: what a map without its block says, and where it was taken.
struct CheckedScan {
  ScanEvidence evidence;
  std::size_t true_place;  ///< number in the lattice
};

/// Chooses the exponents for which the true places have the largest posterior probability.
/// @param checked if empty, the exponents are the defaults
Temper chooseTemper(const PlaceLattice& places, const std::vector<CheckedScan>& checked);

}  // namespace sfw
