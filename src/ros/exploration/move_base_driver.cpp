#include "ros/exploration/move_base_driver.h"

#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

constexpr double kBackOffM = 0.15;  // [m]
constexpr double kBackOffS = 3.0;   // at most [s]
constexpr double kStandsS = 15.0;   // without kMoved the robot is wedged [s]
constexpr double kMoved = 0.1;      // [m]
constexpr int kMostEscapes = 12;    // that move the robot less than kMoved, as with bumpers
constexpr double kRim = 0.3;        // between goals and the rim of the map [m]
constexpr double kShortest = 0.3;   // less of a way is not worth a goal [m]

/// The way up to where it leaves the box.
std::vector<Position> within(const Box& box, const std::vector<Position>& way) {
  constexpr double kStep = 0.05;  // [m]
  std::vector<Position> inside = {way.front()};
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Position from = way[i - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil((way[i] - from).norm() / kStep)));
    Position last = from;
    for (int step = 1; step <= steps; ++step) {
      const Position at = from + (way[i] - from) * (static_cast<double>(step) / steps);
      if (!box.contains(at)) {
        inside.push_back(last);
        return inside;
      }
      last = at;
    }
    inside.push_back(last);
  }
  return inside;
}

}  // namespace

MoveBaseDriver::MoveBaseDriver(const ros::NodeHandle& node, const std::string& map_frame,
                               double speed_m_s)
    : map_frame_(map_frame), speed_m_s_(speed_m_s) {
  ros::NodeHandle handle(node);
  constexpr bool kSpinThread = false;
  client_ = std::make_unique<actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction>>(
      handle, "move_base", kSpinThread);
}

void MoveBaseDriver::setMap(const Box& map) {
  const Position rim(kRim, kRim);
  bounds_ = Box(map.min() + rim, map.max() - rim);
}

void MoveBaseDriver::follow(std::vector<Position> way) {
  if (way.size() < 2) {
    state_ = State::kArrived;
    return;
  }
  if (!bounds_.isEmpty()) {
    const Position whole = way.back();
    way = within(bounds_, way);
    if (way.back() != whole && (way.back() - way.front()).norm() < kShortest) {
      state_ = State::kFailed;
      return;
    }
  }
  const Position& end = way.back();
  const Position along = end - way[way.size() - 2];
  const double yaw = std::atan2(along.y(), along.x());
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose.header.frame_id = map_frame_;
  goal.target_pose.header.stamp = ros::Time::now();
  goal.target_pose.pose.position.x = end.x();
  goal.target_pose.pose.position.y = end.y();
  goal.target_pose.pose.orientation.z = std::sin(yaw / 2.0);
  goal.target_pose.pose.orientation.w = std::cos(yaw / 2.0);
  client_->sendGoal(goal);
  moved_from_.reset();
  state_ = State::kDriving;
}

void MoveBaseDriver::stop() {
  if (state_ == State::kDriving && !backing_) {
    client_->cancelGoal();
  }
  state_ = State::kIdle;
  backing_ = false;
  command_ = {};
}

bool MoveBaseDriver::mayEscapeFrom(const Position& wedged) {
  if (escaped_from_ && (wedged - *escaped_from_).norm() > kMoved) {
    escapes_ = 0;
  }
  escaped_from_ = wedged;
  return ++escapes_ <= kMostEscapes;
}

Driver::State MoveBaseDriver::step(const RobotPose& pose, bool touching, double now_s) {
  command_ = {};
  if (state_ != State::kDriving) {
    return state_;
  }
  if (!moved_from_ || (pose.position - *moved_from_).norm() > kMoved) {
    moved_from_ = pose.position;
    moved_at_s_ = now_s;
  }
  const bool wedged = !backing_ && !touching && now_s - moved_at_s_ > kStandsS;
  if ((touching || wedged) && !backing_) {
    client_->cancelGoal();
    if (wedged && !mayEscapeFrom(pose.position)) {
      state_ = State::kStuck;
      return state_;
    }
    backing_ = true;
    // A robot that also stands with its back to something gets away ahead.
    ahead_ = wedged && !ahead_;
    after_backing_ = wedged ? State::kFailed : State::kBlocked;
    backing_from_ = pose;
    backing_since_s_ = now_s;
  }
  if (backing_) {
    if ((pose.position - backing_from_.position).norm() < kBackOffM &&
        now_s - backing_since_s_ < kBackOffS) {
      command_.speed_m_s = (ahead_ ? 0.5 : -0.5) * speed_m_s_;
    } else {
      backing_ = false;
      moved_at_s_ = now_s;
      state_ = after_backing_;
    }
  } else if (client_->getState().isDone()) {
    state_ = client_->getState() == actionlib::SimpleClientGoalState::SUCCEEDED ? State::kArrived
                                                                                : State::kFailed;
  }
  return state_;
}

}  // namespace sfw
