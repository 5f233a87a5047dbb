#include "exploration/explorer.h"

#include <algorithm>
#include <utility>

namespace sfw {
namespace {

constexpr double kPoseStep = 0.05;     // between the poses that are kept [m]
constexpr double kAbandonedM = 0.5;    // around a goal that failed, no other one comes [m]
constexpr double kAbandonedS = 120.0;  // for this time [s]
constexpr double kHomeM = 0.3;         // the robot is at home this near to its start [m]
constexpr std::size_t kChoice = 8;     // goals to choose from

}  // namespace

void Explorer::setMap(const ExplorationView& map) { map_ = map; }

void Explorer::addPose(const RobotPose& pose, double now_s) {
  if (!started_) {
    started_ = true;
    start_ = pose_ = pose;
    start_s_ = now_s;
    way_.push_back(pose.position);
  }
  driven_m_ += (pose.position - pose_.position).norm();
  pose_ = pose;
  now_s_ = now_s;
  if ((pose.position - way_.back()).norm() >= kPoseStep) {
    way_.push_back(pose.position);
  }
}

void Explorer::addTouch(const Position& point) { touches_.push_back({pose_.position, point}); }

ExplorationView Explorer::view() const {
  ExplorationView view = *map_;
  view.way = way_;
  view.touches = touches_;
  return view;
}

void Explorer::giveUp() {
  if (goal_) {
    abandoned_.push_back({*goal_, now_s_ + kAbandonedS});
    goal_.reset();
  }
}

std::optional<ExplorationGoal> Explorer::next() {
  if (!started_ || !map_ || phase_ == Phase::kFinished) {
    return std::nullopt;
  }
  std::optional<ExplorationGoal> goal;
  if (phase_ == Phase::kExploring) {
    goal = bestGoal();
  }
  if (phase_ == Phase::kReturning) {
    goal = home();
  }
  goal_ = goal ? std::optional<Position>(goal->position) : std::nullopt;
  return goal;
}

std::optional<ExplorationGoal> Explorer::bestGoal() {
  const ExplorationView view = this->view();
  abandoned_.erase(std::remove_if(abandoned_.begin(), abandoned_.end(),
                                  [&](const Abandoned& other) { return other.until_s <= now_s_; }),
                   abandoned_.end());
  // Goals are too far apart for two of them to lie near one that failed.
  goals_ = rankGoals(view, pose_, config_, kChoice + abandoned_.size());
  const auto wanted = [&](const ExplorationGoal& goal) {
    return std::none_of(abandoned_.begin(), abandoned_.end(), [&](const Abandoned& other) {
      return (other.position - goal.position).norm() < kAbandonedM;
    });
  };
  const auto found = std::find_if(goals_.begin(), goals_.end(), wanted);
  if (found == goals_.end()) {
    end("nothing more is worth a drive");
    return std::nullopt;
  }
  if (isLimited() && exceedsLimits(*found, view)) {
    end("the budget is used up");
    return std::nullopt;
  }
  return *found;
}

bool Explorer::isLimited() const { return limits_.time_s > 0.0 || limits_.way_m > 0.0; }

bool Explorer::exceedsLimits(const ExplorationGoal& goal, const ExplorationView& view) const {
  double more_s = goal.travel_s;
  if (limits_.return_home) {
    // From the goal the robot returns by the way it came.
    const std::optional<ExplorationGoal> back = wayTo(view, pose_, start_.position, config_);
    more_s += goal.travel_s + (back ? back->travel_s : 0.0);
  }
  return (limits_.time_s > 0.0 && now_s_ - start_s_ + more_s > limits_.time_s) ||
         (limits_.way_m > 0.0 && driven_m_ + more_s * config_.speed_m_s > limits_.way_m);
}

void Explorer::end(const std::string& why) {
  ending_ = why;
  phase_ = limits_.return_home ? Phase::kReturning : Phase::kFinished;
}

std::optional<ExplorationGoal> Explorer::home() {
  if ((pose_.position - start_.position).norm() < kHomeM) {
    phase_ = Phase::kFinished;
    return std::nullopt;
  }
  std::optional<ExplorationGoal> goal = wayTo(view(), pose_, start_.position, config_);
  if (!goal) {
    ending_ += "; no way home is known";
    phase_ = Phase::kFinished;
  }
  return goal;
}

}  // namespace sfw
