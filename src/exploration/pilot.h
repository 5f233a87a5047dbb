#pragma once

#include <optional>
#include <string>

#include "exploration/driver.h"
#include "exploration/explorer.h"

namespace sfw {

/// Explores: an Explorer says where to, and a Driver drives there. Not thread-safe.
class Pilot {
 public:
  /// @param driver  must outlive this
  Pilot(const ExplorationConfig& config, const Explorer::Limits& limits, Driver& driver);

  /// A newer map. The drive goes on; the next goal is chosen on this map.
  void setMap(const ExplorationView& map) { explorer_.setMap(map); }

  /// One step, ten times a second or more often.
  /// @param touched  the point that the bumper touches [m], map frame; nothing if it does not
  /// @param now_s    of a clock that does not go back [s]
  void step(const RobotPose& pose, const std::optional<Position>& touched, double now_s);

  bool finished() const { return explorer_.phase() == Explorer::Phase::kFinished || stuck(); }
  bool stuck() const { return state_ == Driver::State::kStuck; }

  /// The driver stops, unless all has ended; step() starts it again.
  void pause();

  const Explorer& explorer() const { return explorer_; }
  const std::optional<ExplorationGoal>& goal() const { return goal_; }

 private:
  Explorer explorer_;
  Driver& driver_;
  Driver::State state_ = Driver::State::kIdle;
  std::optional<ExplorationGoal> goal_;
  bool in_touch_ = false;
};

}  // namespace sfw
