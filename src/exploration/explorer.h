#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/exploration.h"

namespace sfw {

/// Decides where an exploring robot drives next, when it returns, and when it has finished.
///
/// The owner reports every pose, touch and map, and asks for a goal whenever the last one was
/// reached or failed. Who drives does not matter: move_base or WayDriver. Not thread-safe.
class Explorer {
 public:
  /// When the robot stops to look for more.
  struct Limits {
    double time_s = 0.0;      ///< since the first pose, the way home included [s]; 0: none
    double way_m = 0.0;       ///< driven, the way home included [m]; 0: none
    bool return_home = true;  ///< to the first pose
  };

  enum class Phase { kExploring, kReturning, kFinished };

  Explorer(const ExplorationConfig& config, const Limits& limits)
      : config_(config), limits_(limits) {}

  void setMap(const ExplorationView& map);
  void addPose(const RobotPose& pose, double now_s);
  void addTouch(const Position& point);

  bool hasMap() const { return map_.has_value(); }

  /// The next drive; nothing without a pose or a map, and once the exploration has finished.
  std::optional<ExplorationGoal> next();

  /// The last goal cannot be reached, though the robot touched nothing: no goal near it comes for
  /// some time.
  void giveUp();

  Phase phase() const { return phase_; }

  /// Why the exploration ended or turned home, in words; empty before.
  const std::string& ending() const { return ending_; }

  /// The goals of the last choice, the best first.
  const std::vector<ExplorationGoal>& goals() const { return goals_; }

  const RobotPose& pose() const { return pose_; }
  double driven() const { return driven_m_; }  ///< [m]
  const std::vector<Touch>& touches() const { return touches_; }

 private:
  struct Abandoned {
    Position position;
    double until_s;
  };

  std::optional<ExplorationGoal> bestGoal();
  std::optional<ExplorationGoal> home();
  bool isLimited() const;
  bool exceedsLimits(const ExplorationGoal& goal, const ExplorationView& view) const;
  void end(const std::string& why);
  ExplorationView view() const;

  ExplorationConfig config_;
  Limits limits_;
  Phase phase_ = Phase::kExploring;
  std::string ending_;
  std::optional<ExplorationView> map_;
  std::vector<Position> way_;
  std::vector<Touch> touches_;
  std::vector<ExplorationGoal> goals_;
  std::vector<Abandoned> abandoned_;
  std::optional<Position> goal_;
  bool started_ = false;
  RobotPose start_, pose_;
  double start_s_ = 0.0;
  double now_s_ = 0.0;
  double driven_m_ = 0.0;
};

}  // namespace sfw
