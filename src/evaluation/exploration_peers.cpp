#include "evaluation/exploration_peers.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "base/constants.h"
#include "base/random.h"
#include "base/random_streams.h"
#include "evaluation/frontier_policy.h"
#include "exploration/pilot.h"
#include "exploration/way_driver.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kSpeed = 0.5;    // [m/s]
constexpr double kYawRate = 1.5;  // of turns on the spot [rad/s]
constexpr double kStep = 0.1;     // of the run [s]

class ExplorerPolicy : public ExplorationPolicy {
 public:
  ExplorerPolicy()
      : driver_(WayDriver::Config()), pilot_(ExplorationConfig(), Explorer::Limits(), driver_) {}
  DriveCommand step(const RobotPose& pose, const std::optional<Position>& touched,
                    double now_s) override {
    pilot_.step(pose, touched, now_s);
    return driver_.command();
  }
  bool usesMaps() const override { return true; }
  void setMap(const Snapshot& map) override { pilot_.setMap(viewOf(map)); }
  bool finished() const override { return pilot_.finished(); }
  bool stuck() const override { return pilot_.stuck(); }

 private:
  WayDriver driver_;
  Pilot pilot_;
};

/// A policy of commands that last a while, one after the other; a touch begins new ones.
class ScriptedPolicy : public ExplorationPolicy {
 public:
  DriveCommand step(const RobotPose& /*pose*/, const std::optional<Position>& touched,
                    double /*now_s*/) override {
    if (touched && !in_touch_) {
      interrupted_ = !script_.empty();
      script_.clear();
      add(-0.5 * kSpeed, 0.0, 0.12 / (0.5 * kSpeed));
      afterTouch();
    }
    in_touch_ = touched.has_value();
    while (!script_.empty() && script_.front().seconds < kStep / 2.0) {
      script_.erase(script_.begin());
    }
    if (script_.empty()) {
      return between();
    }
    script_.front().seconds -= kStep;
    return script_.front().command;
  }

 protected:
  virtual void afterTouch() = 0;
  virtual DriveCommand between() = 0;

  /// Whether the last touch came before its script had ended.
  bool interrupted() const { return interrupted_; }

  void add(double speed_m_s, double yaw_rate_rad_s, double seconds) {
    script_.push_back({{speed_m_s, yaw_rate_rad_s}, seconds});
  }
  void turn(double angle_rad) {
    add(0.0, std::copysign(kYawRate, angle_rad), std::abs(angle_rad) / kYawRate);
  }

 private:
  struct Piece {
    DriveCommand command;
    double seconds;
  };
  std::vector<Piece> script_;
  bool in_touch_ = false;
  bool interrupted_ = false;
};

class RandomWalk : public ScriptedPolicy {
 public:
  explicit RandomWalk(std::int64_t seed) : random_(seed, streamOf(Purpose::kRandomWalk), 0) {}

 private:
  void afterTouch() override { turn((0.5 + random_.uniform()) * kPi); }
  DriveCommand between() override { return {kSpeed, 0.0}; }
  Random random_;
};

class WallFollowing : public ScriptedPolicy {
  void afterTouch() override {
    found_ = true;
    turn(kPi / 6.0);
  }
  // An arc of 0.4 m leads back to the wall, and around corners.
  DriveCommand between() override { return {kSpeed, found_ ? -kSpeed / 0.4 : 0.0}; }
  bool found_ = false;
};

class Lawnmower : public ScriptedPolicy {
 public:
  explicit Lawnmower(std::int64_t seed) : random_(seed, streamOf(Purpose::kRandomWalk), 0) {}

 private:
  void afterTouch() override {
    if (interrupted()) {  // beside the lane is a wall: the robot begins elsewhere
      turn((0.5 + random_.uniform()) * kPi);
      return;
    }
    turn(side_ * kPi / 2.0);
    add(kSpeed, 0.0, 0.5 / kSpeed);
    turn(side_ * kPi / 2.0);
    side_ = -side_;
  }
  DriveCommand between() override { return {kSpeed, 0.0}; }
  Random random_;
  double side_ = 1.0;
};

/// Follows a route that was planned in truth.
class KnownRoute : public ExplorationPolicy {
 public:
  KnownRoute(const FloorPlan& plan, const Position& start) : driver_(WayDriver::Config()) {
    RoutePlannerConfig config;
    config.robot_radius_m = 0.15;
    config.start_in_map = start;
    driver_.follow(planRoute(toStates(plan), RouteKind::kWalls, config));
  }
  DriveCommand step(const RobotPose& pose, const std::optional<Position>& touched,
                    double now_s) override {
    state_ = driver_.step(pose, touched.has_value(), now_s);
    if (state_ == Driver::State::kBlocked) {
      driver_.follow(driver_.rest());
    }
    return driver_.command();
  }
  bool seesTruth() const override { return true; }
  bool finished() const override { return state_ == Driver::State::kArrived; }
  bool stuck() const override { return state_ == Driver::State::kStuck; }

 private:
  WayDriver driver_;
  Driver::State state_ = Driver::State::kIdle;
};

}  // namespace

std::vector<std::string> explorationPolicyNames() {
  return {"explorer", "nearest_frontier", "random_walk", "wall_following", "lawnmower", "walls"};
}

std::unique_ptr<ExplorationPolicy> makeExplorationPolicy(const std::string& name,
                                                         const FloorPlan& plan,
                                                         const Position& start, std::int64_t seed) {
  if (name == "explorer") {
    return std::make_unique<ExplorerPolicy>();
  }
  if (name == "nearest_frontier") {
    return std::make_unique<FrontierPolicy>();
  }
  if (name == "random_walk") {
    return std::make_unique<RandomWalk>(seed);
  }
  if (name == "wall_following") {
    return std::make_unique<WallFollowing>();
  }
  if (name == "lawnmower") {
    return std::make_unique<Lawnmower>(seed);
  }
  if (name == "walls") {
    return std::make_unique<KnownRoute>(plan, start);
  }
  std::string names;
  for (const std::string& known : explorationPolicyNames()) {
    names += (names.empty() ? "" : ", ") + known;
  }
  throw InputError("there is no policy '" + name + "'; choose one of " + names);
}

}  // namespace sfw
