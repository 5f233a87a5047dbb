#include "exploration/way_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.h"

namespace sfw {
namespace {

constexpr double kGain = 2.5;         // of headings: yaw rate over error [1/s]
constexpr double kTurnBegins = 0.6;   // error of the heading at which the robot stops to turn [rad]
constexpr double kTurnEnds = 0.3;     // [rad]
constexpr double kLookahead = 0.2;    // [m]
constexpr double kMotion = 0.05;      // less is no motion [m]
constexpr double kTurnMotion = 0.2;   // less is no turn [rad]
constexpr double kReflexShare = 0.5;  // of the speed, in reflexes
constexpr double kReflexLimit = 3.0;  // a reflex ends then at the latest [s]
constexpr double kLeaveM = 0.3;       // length of a drive that frees the robot [m]
constexpr double kEscapeTurn = 2.4;   // the golden angle: directions never repeat [rad]

double difference(double to, double from) { return std::remainder(to - from, 2.0 * kPi); }

}  // namespace

void WayDriver::follow(std::vector<Position> way) {
  way_ = std::move(way);
  next_ = 0;
  turning_ = false;
  state_ = way_.empty() ? State::kArrived : State::kDriving;
  last_moved_.reset();
}

void WayDriver::stop() {
  way_.clear();
  state_ = State::kIdle;
  command_ = {};
  reflex_ = Reflex::kNone;
}

Driver::State WayDriver::step(const RobotPose& pose, bool touching, double now_s) {
  command_ = {};
  if (reflex_ == Reflex::kNone && state_ == State::kDriving) {
    const bool comes_forward = comesForward(pose, now_s);
    if (touching || comes_forward) {
      escaping_ = false;
    } else if (++escapes_ > config_.most_escapes) {
      state_ = State::kStuck;
    } else {
      escaping_ = true;
    }
    if (state_ == State::kDriving && (touching || !comes_forward)) {
      begin(Reflex::kBackOff, pose, now_s);
    }
  }
  if (reflex_ != Reflex::kNone) {
    reflex(pose, touching, now_s);
  } else if (state_ == State::kDriving) {
    drive(pose);
  }
  return state_;
}

bool WayDriver::comesForward(const RobotPose& pose, double now_s) {
  if (!last_moved_ || (pose.position - last_moved_->position).norm() > kMotion ||
      std::abs(difference(pose.yaw_rad, last_moved_->yaw_rad)) > kTurnMotion) {
    if (last_moved_ && (pose.position - last_moved_->position).norm() > kMotion) {
      escapes_ = 0;
    }
    last_moved_ = pose;
    last_moved_s_ = now_s;
  }
  return now_s - last_moved_s_ < config_.patience_s;
}

void WayDriver::drive(const RobotPose& pose) {
  while (next_ < way_.size() && (way_[next_] - pose.position).norm() < config_.arrival_m) {
    ++next_;
  }
  if (next_ == way_.size()) {
    state_ = State::kArrived;
    return;
  }
  const Position to = way_[next_] - pose.position;
  const double error = difference(std::atan2(to.y(), to.x()), pose.yaw_rad);
  turning_ = std::abs(error) > (turning_ ? kTurnEnds : kTurnBegins);
  command_.yaw_rate_rad_s = turnRate(error);
  if (!turning_) {
    const bool last = next_ + 1 == way_.size();
    const double slow = last ? std::min(to.norm() / kLookahead + 0.2, 1.0) : 1.0;
    command_.speed_m_s = config_.speed_m_s * slow * std::cos(error);
  }
}

void WayDriver::begin(Reflex reflex, const RobotPose& pose, double now_s) {
  reflex_ = reflex;
  reflex_from_ = pose;
  reflex_start_s_ = now_s;
  if (reflex == Reflex::kTurn) {
    escape_yaw_rad_ = pose.yaw_rad + kEscapeTurn;
  }
}

void WayDriver::reflex(const RobotPose& pose, bool touching, double now_s) {
  const double moved = (pose.position - reflex_from_.position).norm();
  const bool late = now_s - reflex_start_s_ > kReflexLimit;
  switch (reflex_) {
    case Reflex::kNone:
      break;
    case Reflex::kBackOff:
      if (moved < config_.back_off_m && !late) {
        command_.speed_m_s = -kReflexShare * config_.speed_m_s;
      } else if (escaping_) {
        begin(Reflex::kTurn, pose, now_s);
      } else {
        reflex_ = Reflex::kNone;
        state_ = State::kBlocked;
      }
      break;
    case Reflex::kTurn: {
      const double error = difference(escape_yaw_rad_, pose.yaw_rad);
      if (std::abs(error) > kTurnEnds && !late) {
        command_.yaw_rate_rad_s = turnRate(error);
      } else {
        begin(Reflex::kLeave, pose, now_s);
      }
      break;
    }
    case Reflex::kLeave:
      if (moved < kLeaveM && !touching && !late) {
        command_.speed_m_s = kReflexShare * config_.speed_m_s;
      } else {
        reflex_ = Reflex::kNone;
        state_ = State::kBlocked;
      }
      break;
  }
}

double WayDriver::turnRate(double error_rad) const {
  return std::clamp(kGain * error_rad, -config_.yaw_rate_rad_s, config_.yaw_rate_rad_s);
}

}  // namespace sfw
