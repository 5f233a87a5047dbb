#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "grid/mask.h"
#include "radio/radio_bins.h"
#include "tomography/line_field.h"

namespace sfw {

/// The data of a wall field that change while a robot drives.
struct WallData {
  double yaw_rad = 0.0;                        ///< of the building frame in the map frame
  std::vector<AccessPointBins> access_points;  ///< building frame
  Mask path;                                   ///< cells that the robot's antenna crossed
};

/// The members of a live map's wall field, kept from one refresh to the next.
///
/// A refresh solves one member anew: the oldest one, if the data have grown by a hundredth since.
/// The others stay as they were (doc/method/walls.md). Members too old to use are solved at once,
/// too. Without new data, each refresh solves one member, and as many refreshes as there are
/// members give the wall field of estimateWalls. The settings must stay the same; clear() if they
/// change. Not thread-safe.
class KeptMembers {
 public:
  /// Solves a member of the ensemble from the data of now.
  using Solve = std::function<LineField(int member)>;

  /// Refreshes the members.
  /// @param members  number of members, at least 1
  /// @param stop     polled; when it turns true the result is incomplete, and nothing more is kept
  /// @return all members, in the building frame of the data. Their lattices need not cover it.
  std::vector<LineField> refresh(const WallData& now, int members, const Solve& solve,
                                 const std::atomic<bool>& stop);

  /// Whether some members were solved from other data than those of the last refresh.
  bool isUnfinished() const;

  /// Forgets all members.
  void clear() { *this = {}; }

 private:
  /// A member, and the data that it was solved from.
  struct Member {
    LineField walls;
    std::uint64_t version = 0;  // of the data; 0: none
    double yaw_rad = 0.0;
    double readings = 0.0;
    double bins = 0.0;
    std::vector<Position> access_points_in_map;
  };

  static bool hasGrownSince(const Member& member, const WallData& now);
  static bool isTooOld(const Member& member, const WallData& now);

  std::vector<Member> members_;
  std::optional<WallData> last_;
  std::uint64_t version_ = 0;  // of the last data: counts their changes
};

}  // namespace sfw
