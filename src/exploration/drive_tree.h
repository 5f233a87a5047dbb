#pragma once

#include <vector>

#include "exploration/exploration_field.h"
#include "structure_from_wifi/exploration.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The quickest drives from a robot to every cell, and what each teaches on its way.
///
/// The time of a drive includes that of the touches to expect. O(cells log cells).
class DriveTree {
 public:
  DriveTree(const ExplorationView& view, const RobotPose& robot, const ExplorationConfig& config);

  const GridGeometry& geometry() const { return field_.geometry(); }

  /// The cells that the robot may reach, by rising time.
  const std::vector<Cell>& reached() const { return reached_; }

  /// Free space and walls that a drive to a reached cell is expected to find [m2].
  double gain(Cell c) const { return nodes_[c].area + nodes_[c].ahead + nodes_[c].walls; }

  /// The gain over the time [m2/s].
  double rate(Cell c) const;

  /// The drive to a reached cell, with as few corners as are safe.
  ExplorationGoal goal(Cell c) const;

 private:
  struct Node {
    Cell before;
    double arrival = 1.0;  // probability to get here without a touch
    double area = 0.0;     // expected on the way here [m2]
    double ahead = 0.0;    // expected around this place [m2]
    double walls = 0.0;    // worth of the rays to the way here [m2]
  };

  void search();
  void reach(Cell c);
  double turnTo(Cell next) const;
  double newRays(Cell c) const;
  bool safe(const Position& from, const Position& to, float worst) const;
  std::vector<Position> wayTo(Cell c) const;

  ExplorationConfig config_;
  RobotPose robot_;
  ExplorationField field_;
  Cell start_;
  Grid<Node> nodes_;
  Grid<double> time_;  // expected [s]
  std::vector<Cell> reached_;
  std::vector<WallSegment> undecided_;
  std::vector<Position> access_points_;
};

}  // namespace sfw
