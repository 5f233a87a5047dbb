#include "exploration/pilot.h"

namespace sfw {

Pilot::Pilot(const ExplorationConfig& config, const Explorer::Limits& limits, Driver& driver)
    : explorer_(config, limits), driver_(driver) {}

void Pilot::step(const RobotPose& pose, const std::optional<Position>& touched, double now_s) {
  explorer_.addPose(pose, now_s);
  if (touched && !in_touch_) {
    explorer_.addTouch(*touched);
  }
  in_touch_ = touched.has_value();
  state_ = driver_.step(pose, in_touch_, now_s);
  if (state_ == Driver::State::kDriving || finished()) {
    return;
  }
  if (state_ == Driver::State::kFailed) {
    explorer_.giveUp();
  }
  goal_ = explorer_.next();
  if (goal_) {
    driver_.follow(goal_->way);
  } else {
    driver_.stop();
  }
}

void Pilot::pause() {
  if (finished()) {
    return;
  }
  driver_.stop();
  state_ = Driver::State::kIdle;
  goal_.reset();
}

}  // namespace sfw
