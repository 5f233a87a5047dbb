#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "structure_from_wifi/access_point_estimate.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Shows whether the signals agree where the path returns to a place.
struct DriftFinding {
  /// Mean square difference of signals within 0.3 m of a place, over that at 2 to 3 m. It is .1 to
  /// .4 with good poses and near 1 with drifted ones.
  double ratio = 0.0;
  std::size_t returns = 0;  ///< stretches of 0.25 m to which the path returned
  bool suspect = false;     ///< the poses seem to have drifted
};

/// The results of checking the data of a map.
struct DataFindings {
  /// The fit of the readings to each access point of the table; empty without a result.
  std::vector<std::optional<AccessPointFit>> fits;
  std::optional<DriftFinding> drift;  ///< empty without a result, or without a check
  bool unfinished = false;            ///< some access points wait for the next check

  /// The fit of an access point by its index in the table, or nullptr.
  const AccessPointFit* fit(std::size_t access_point) const {
    return access_point < fits.size() && fits[access_point] ? &*fits[access_point] : nullptr;
  }
};

/// Checks the data of a map: the poses, and the positions of access points in the table. A checker
/// remembers its results, since a live map is checked again and again.
/// Not thread-safe.
class SFW_EXPORT DataChecker {
 public:
  /// Checks everything anew: the result depends on the snapshot alone. Takes about 0.02 s for each
  /// access point. Once `stop` is true, the rest stays unchecked; it is polled between access
  /// points.
  /// @{
  DataFindings checkAll(const Snapshot& snapshot, const std::atomic<bool>& stop);
  DataFindings checkAll(const Snapshot& snapshot);
  /// @}

  /// Checks the access points whose readings have changed most, 4 at most. An access point has
  /// changed if it has a tenth more readings than at its last check. It has also changed if a
  /// correction of the path moved its readings. The others keep their last result. Does not look
  /// for drift.
  DataFindings checkChanged(const Snapshot& snapshot, const std::atomic<bool>& stop);

 private:
  /// The last check of an access point and its data.
  struct Checked {
    std::size_t readings = 0;
    Position last_position = Position::Zero();  // of the last reading [m]
    std::size_t round = 0;                      // of checkChanged
    std::optional<AccessPointFit> fit;
  };

  static double changeOf(const Checked& checked, const std::vector<Sample>& samples);
  static Checked check(const AccessPointSummary& summary);
  DataFindings findings() const;

  std::vector<Checked> checked_;  // in the order of the table
  std::size_t round_ = 0;         // number of calls of checkChanged
};

}  // namespace sfw
