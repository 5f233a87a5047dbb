#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "access_points/access_point_estimation.h"
#include "structure_from_wifi/export.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Doubts what a map was made from: positions of access points that the table gives
/// (accessPointFit), and poses (checkDrift). Remembers its judgements of access points, as a map
/// that grows is judged again and again.
/// Not thread-safe.
class SFW_EXPORT DataChecker {
 public:
  /// Judges everything anew: the result depends on the readings alone.
  /// @param mapper    that the snapshot was made by
  /// @param snapshot  gets the fits, and what drift was found
  /// @param stop      polled between access points; what is left stays unjudged once it is true
  /// Costs some 0.1 s for each access point.
  void checkAll(const Mapper& mapper, Snapshot& snapshot, const std::atomic<bool>& stop);
  void checkAll(const Mapper& mapper, Snapshot& snapshot);

  /// Judges anew the access points whose readings have changed most, 4 at most: those with a tenth
  /// more than at their last judgement, or moved by a correction of the path. The others keep their
  /// last fit. Looks for no drift.
  /// @return whether some are left for the next time
  bool checkChanged(const Mapper& mapper, Snapshot& snapshot, const std::atomic<bool>& stop);

 private:
  /// The last judgement of an access point, and what it was made from.
  struct Known {
    std::size_t readings = 0;
    Position last_place = Position::Zero();  // where the last of them was taken [m]
    std::size_t round = 0;                   // of checkChanged
    std::optional<AccessPointFit> fit;
  };

  static double change(const Known& known, const std::vector<Sample>& samples);
  void judge(const AccessPoint& access_point, const std::vector<Sample>& samples, Known& known);
  void note(Snapshot& snapshot) const;

  std::vector<Known> known_;  // in the order of the table
  std::size_t round_ = 0;     // how often checkChanged was asked
};

}  // namespace sfw
