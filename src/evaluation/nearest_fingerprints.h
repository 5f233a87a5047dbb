#pragma once

#include <cstddef>
#include <vector>

#include "localization/scan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Localisation by the nearest fingerprints (RADAR, Bahl and Padmanabhan 2000): the baseline of
/// localisation.
///
/// The estimate is the mean position of the k mapped scans whose strengths are nearest by Euclidean
/// distance. A radio that a scan lacks counts as heard 1 dB below the weakest mapped reading.
class NearestFingerprints {
 public:
  /// Chooses k in 1..15, and whether nearer scans weigh more (by one over the distance), by the
  /// least median error on the mapped scans, where blocks of the way are held out by turns.
  /// @param mapped   at least one scan, by time; must outlive this
  /// @param block_m  way of each block
  NearestFingerprints(const std::vector<Scan>& mapped, double block_m);

  Position locate(const Scan& scan) const;

  std::size_t neighbours() const { return neighbours_; }
  bool weighted() const { return weighted_; }

 private:
  const std::vector<Scan>& mapped_;
  double missing_dbm_ = -100.0;
  std::size_t neighbours_ = 1;
  bool weighted_ = false;
};

}  // namespace sfw
