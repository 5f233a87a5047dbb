#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Moves a robot along ways. Not thread-safe.
class Driver {
 public:
  enum class State {
    kIdle,     ///< there is no way
    kDriving,  ///< on the way, or freeing itself
    kArrived,  ///< at the end of the way
    kBlocked,  ///< the robot touched something, and has backed off
    kFailed,   ///< the end of the way cannot be reached, though the robot touched nothing
    kStuck     ///< nothing frees the robot
  };

  virtual ~Driver() = default;

  /// Starts a way. @param way  [m], map frame, in order
  virtual void follow(std::vector<Position> way) = 0;

  /// Stops and forgets the way.
  virtual void stop() = 0;

  /// One step, ten times a second or more often.
  /// @param touching  the bumper is pressed
  /// @param now_s     of a clock that does not go back [s]
  virtual State step(const RobotPose& pose, bool touching, double now_s) = 0;
};

}  // namespace sfw
