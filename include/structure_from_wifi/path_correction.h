#pragma once

#include <cstdint>
#include <vector>

#include "structure_from_wifi/export.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Where the robot was said to be at a time, and the correction of the odometry behind that.
struct OdometryCorrection {
  std::int64_t stamp_ns = 0;                   ///< of the pose
  Position antenna_in_map = Position::Zero();  ///< [m]
  Position odom_in_map = Position::Zero();     ///< origin of the odometry's frame [m]
  double odom_yaw_rad = 0.0;                   ///< of the odometry's frame in the map's
};

/// How a path moves when a localisation corrects the past. Immutable.
class SFW_EXPORT PathCorrection {
 public:
  /// Moves nothing.
  PathCorrection() = default;

  /// True if every point stays where it is.
  bool empty() const { return moves_.empty(); }

  /// Where a point belongs that the robot sensed at a time, moved along with the antenna of then.
  /// A point whose time has no fix stays where it is, to the last bit. O(log fixes).
  Position moved(std::int64_t stamp_ns, const Position& point_in_map) const;

 private:
  friend class PathCorrector;

  struct Move {
    std::int64_t stamp_ns = 0;
    Position from = Position::Zero();
    Position to = Position::Zero();
    double turn_rad = 0.0;
  };

  std::vector<Move> moves_;  // by stamp
};

/// Ties what was sensed to the odometry, so that it follows when the past turns out wrong.
///
/// Between two fixes a localisation may correct the odometry. Small corrections are taken as they
/// are. A larger one, a jump, tells that the path before it was wrong too, though tf never says
/// so: after a loop closure by SLAM, the drift of the way back to the last jump. As drift grows
/// with the way driven, the jump is spread over that way in proportion, the turn first and what is
/// then left of the displacement after it: what the optimisation of a pose graph does to first
/// order. Where that way is too short for so much drift, the jump reaches further back; and if the
/// whole drive is too short, it moves as a whole, as after a wrong pose at the start.
///
/// What the corrected path is follows from the set of fixes alone, not from the order in which
/// they came. Not thread-safe.
class SFW_EXPORT PathCorrector {
 public:
  /// A correction that changes by more than this from a fix to the next is a jump.
  struct Tolerance {
    double distance_m = 0.1;  ///< of the antenna
    double turn_rad = 0.05;   ///< of the odometry's frame
  };

  /// Whether the odometry is corrected by a jump from one fix to another.
  static bool isJump(const OdometryCorrection& before, const OdometryCorrection& after,
                     const Tolerance& tolerance);

  PathCorrector() = default;
  /// @param tolerance  between jumps and small corrections
  explicit PathCorrector(const Tolerance& tolerance) : tolerance_(tolerance) {}

  /// Adds a fix; of several of one time, one counts. What is not finite is left out.
  void insert(const OdometryCorrection& fix);

  /// Forgets all fixes.
  void clear() { fixes_.clear(); }

  /// The number of fixes.
  std::size_t size() const { return fixes_.size(); }

  /// The correction of the past that all fixes together ask for.
  /// O(fixes log fixes), and for each jump the fixes that it moves.
  PathCorrection correction() const;

 private:
  /// The last fix of a jump that begins at a fix, of fixes by stamp.
  std::size_t endOfJump(const std::vector<OdometryCorrection>& fixes, std::size_t begin) const;

  Tolerance tolerance_;
  std::vector<OdometryCorrection> fixes_;
};

}  // namespace sfw
