#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "localization/pose_graph.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// How a path by odometry is corrected where the robot returned to places that sound the same.
struct LoopClosure {
  enum class Finding {
    kFewRadios,    ///< fewer than four radios: they sound alike at far places
    kNoLoop,       ///< the robot never returned to a place that it had heard before
    kNoDrift,      ///< the path is as good as the radio can tell
    kContradicts,  ///< no path of a robot agrees with the signals
    kDrift,        ///< the path drifted: only then use the correction
  };
  Finding finding = Finding::kNoLoop;

  /// The stretches of the way: time of their first reading, by time.
  std::vector<std::int64_t> stamps_ns;
  std::vector<Position> odometry;  ///< their positions as odometry tells them [m]
  Trajectory path;                 ///< their corrected positions, and turns of the odometry

  std::size_t closings = 0;  ///< stretches in which the robot was back at a mapped place

  /// How far the closings are from the path of the odometry, and from the corrected one.
  struct Misfit {
    double distance_m = 0.0;  ///< median
    double in_sigmas = 0.0;   ///< median in units of their standard deviation; 1 by chance alone
  };
  Misfit before, after;

  /// How much more the path bends than odometry errs, as of strainOf, for each metre.
  double strain_per_m = 0.0;

  double farthest_moved_m = 0.0;  ///< of a stretch

  /// Where a point was that the robot sensed at a time, by the corrected path.
  /// O(log stretches).
  Position moved(std::int64_t stamp_ns, const Position& point) const;
};

/// Finds where a robot returned, and corrects its path.
///
/// The drive is taken in blocks. A particle filter localises each block on the radio map of the way
/// before it, corrected as far as it is by then. A stretch that sounds like a mapped place closes a
/// loop (doc/method/localisation.md).
///
/// @param readings of one robot, in any order, at the positions that its odometry tells
/// @param seed     of the particle filter
/// @param stop     once it is true, the result is incomplete; may be nullptr
/// @return the path of the odometry, without closings, if the way is shorter than 30 m.
/// Deterministic for a seed. The cost is that of at most 24 radio maps.
LoopClosure closeLoops(const std::vector<Reading>& readings, std::int64_t seed,
                       const std::atomic<bool>* stop = nullptr);

/// The same for each robot, by its name.
/// @param readings of all robots, in any order
std::map<std::string, LoopClosure> closeLoopsByRobot(const std::vector<Reading>& readings,
                                                     std::int64_t seed,
                                                     const std::atomic<bool>* stop = nullptr);

}  // namespace sfw
