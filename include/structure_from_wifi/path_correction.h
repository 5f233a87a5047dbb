#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "structure_from_wifi/export.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The position of the antenna at a time, and its transform from odometry to map.
struct OdometryCorrection {
  std::int64_t stamp_ns = 0;                   ///< of the pose
  Position antenna_in_map = Position::Zero();  ///< [m]
  Position odom_in_map = Position::Zero();     ///< origin of the odometry's frame [m]
  double odom_yaw_rad = 0.0;                   ///< of the odometry's frame in the map frame

  /// Whether the pose lies between readings. Such a pose is moved with them, but a jump is sought
  /// from reading to reading only: tf may divide a jump into small steps.
  bool is_between = false;

  std::string robot = {};  ///< name of the robot; empty: the only one
};

/// Moves points of the past by a later correction of the path. Immutable.
class SFW_EXPORT PathCorrection {
 public:
  /// Creates a correction that moves nothing.
  PathCorrection() = default;

  /// True if every point stays where it is.
  bool empty() const { return moves_.empty(); }

  /// Returns the corrected position of a point that the robot sensed at a time. The point moves
  /// with the antenna of that time. A point without a correction at its time keeps exactly its
  /// position. Each robot has corrections of its own. O(log corrections).
  Position moved(std::int64_t stamp_ns, const Position& point_in_map,
                 const std::string& robot = {}) const;

 private:
  friend class PathCorrector;

  struct Move {
    std::string robot;
    std::int64_t stamp_ns = 0;
    Position from = Position::Zero();
    Position to = Position::Zero();
    double turn_rad = 0.0;
  };

  std::vector<Move> moves_;  // by robot and stamp
};

/// Corrects the past path when the transform from odometry to map jumps.
///
/// A localisation changes that transform all the time. Small changes are accepted without further
/// correction. A larger one, a jump, means that the path before it was wrong too, although tf never
/// corrects the past. After a loop closure by SLAM, the error is the drift since the last jump.
/// Drift grows with the distance driven, so the jump is spread over that distance in proportion:
/// the turn first, then the rest of the displacement. The optimisation of a pose graph does the
/// same to first order. If the distance is too short for so much drift, the jump reaches further
/// back. If the whole drive is too short, it moves as a whole, as after a wrong pose at the start.
///
/// Robots are corrected each by itself. The result depends on the set of corrections alone, not on
/// their order. Not thread-safe.
class SFW_EXPORT PathCorrector {
 public:
  /// A change from one correction to the next that exceeds either limit is a jump.
  struct Tolerance {
    double distance_m = 0.1;  ///< of the antenna
    double turn_rad = 0.05;   ///< of the odometry's frame
  };

  /// Returns whether the odometry is corrected by a jump between two corrections.
  static bool isJump(const OdometryCorrection& before, const OdometryCorrection& after,
                     const Tolerance& tolerance);

  PathCorrector() = default;
  /// @param tolerance  between jumps and small corrections
  explicit PathCorrector(const Tolerance& tolerance) : tolerance_(tolerance) {}

  /// Adds a correction. Of several corrections at one time only one counts. A correction that is
  /// not finite is ignored.
  void insert(const OdometryCorrection& correction);

  /// Forgets all corrections.
  void clear() { corrections_.clear(); }

  /// Returns the number of corrections.
  std::size_t size() const { return corrections_.size(); }

  /// Returns the correction of the past that follows from all odometry corrections. It is empty if
  /// they go to and fro between two places, or if the odometry does not move with the antenna.
  /// O(n log n) for n corrections, and for each jump O(corrections that it moves).
  PathCorrection correction() const;

 private:
  /// Adds the moves of one robot, which has these corrections, by stamp.
  void addMoves(const std::vector<OdometryCorrection>& corrections, PathCorrection& result) const;

  /// Returns the index of the last correction of the jump that begins at `begin`.
  /// @param readings  the corrections at readings, by stamp
  std::size_t endOfJump(const std::vector<OdometryCorrection>& readings, std::size_t begin) const;

  Tolerance tolerance_;
  std::vector<OdometryCorrection> corrections_;
};

}  // namespace sfw
