#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "evaluation/exploration_run.h"
#include "exploration/way_driver.h"
#include "structure_from_wifi/exploration.h"

namespace sfw {

/// Drives to frontiers of the map by the rules of explore_lite 2.1 (Hörner, "Map-merging for
/// multi-robot system", 2016) with the settings of its launch file.
///
/// A frontier is a connected set of unknown cells beside free ones that the robot reaches through
/// free cells. Its cost is 3 times the distance of its nearest cell [m] times
/// the resolution [m], as explore_lite has it, less its length [m]. The robot
/// drives to the centroid of the cheapest one. It is helped: a frontier all around the robot has
/// its centroid there, and the exploration would end at once, so frontiers are cut at the lines of
/// a lattice of 1 m. A frontier is given up after 30 s without progress. Touches are obstacles for
/// the planner.
class FrontierPolicy : public ExplorationPolicy {
 public:
  FrontierPolicy();

  DriveCommand step(const RobotPose& pose, const std::optional<Position>& touched,
                    double now_s) override;
  bool usesMaps() const override { return true; }
  void setMap(const Snapshot& map) override;
  bool finished() const override { return finished_; }
  bool stuck() const override { return state_ == Driver::State::kStuck; }

 private:
  struct Frontier {
    Position centroid;
    double cost;
  };

  std::vector<Frontier> frontiers(const Position& robot) const;
  void choose(const RobotPose& pose, double now_s);
  bool blacklisted(const Position& goal) const;

  WayDriver driver_;
  Driver::State state_ = Driver::State::kIdle;
  std::optional<ExplorationView> view_;
  std::vector<Touch> touches_;
  std::vector<Position> way_;
  std::vector<Position> blacklist_;
  std::optional<Position> goal_;
  double least_distance_m_ = 0.0;                               // to the goal so far
  double chosen_s_ = -std::numeric_limits<double>::infinity();  // time of the last choice
  double progress_s_ = 0.0;                                     // time of the last progress
  bool in_touch_ = false;
  bool finished_ = false;
};

}  // namespace sfw
