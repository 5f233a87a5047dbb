#pragma once

#include <optional>

#include "evaluation/exploration_run.h"
#include "evaluation/navigation_evaluation.h"
#include "simulation/building/floor_plan.h"

namespace sfw {

/// What an exploration has found out.
struct ExplorationScore {
  double known_m2 = 0.0;  ///< free in map and truth [m2]
  double wrong_m2 = 0.0;  ///< free in the map, not in truth [m2]
  double truth_m2 = 0.0;  ///< that the robot can cover in truth [m2]
  NavigationMetrics all;  ///< between places of a drive along all walls
  NavigationMetrics own;  ///< between places of the path itself
};

/// Scores maps of one plan.
///
/// Walls and routes are asked for between places of one drive along all walls of the plan, so all
/// policies are asked the same: what a map does not know, it gets wrong.
class ExplorationScorer {
 public:
  /// @param start  of that drive [m]
  ExplorationScorer(const FloorPlan& plan, const Position& start);

  ExplorationScore scoreOf(const Snapshot& map) const;

 private:
  Grid<CellState> truth_;
  double truth_m2_;
  NavigationEvaluation navigation_;
};

}  // namespace sfw
