#include "evaluation/exploration_score.h"

#include <cstdint>
#include <vector>

#include "grid/for_each_cell.h"
#include "grid/morphology.h"
#include "simulation/robot/configuration_space.h"
#include "simulation/robot/route_planner.h"
#include "structure_from_wifi/exploration.h"

namespace sfw {
namespace {

constexpr double kRadius = 0.15;  // of the robot [m]
constexpr NavigationSample kSample{20000, 60};

std::vector<Position> placesOf(const Grid<CellState>& truth, const Position& start) {
  RoutePlannerConfig config;
  config.robot_radius_m = kRadius;
  config.start_in_map = start;
  const std::vector<Position> corners = planRoute(truth, RouteKind::kWalls, config);
  constexpr double kStep = 0.1;  // [m]
  std::vector<Position> places;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Position along = corners[i] - corners[i - 1];
    for (double driven = 0.0; driven < along.norm(); driven += kStep) {
      places.push_back(corners[i - 1] + driven * along.normalized());
    }
  }
  return places;
}

/// The cells that the robot covers when it has been everywhere.
double coverableArea(const Grid<CellState>& truth, const Position& start) {
  ConfigurationSpace space(truth, kRadius);
  space.keepConnectedTo(truth.geometry.cellAt(start));
  const Mask covered = dilated(space.cells(), space.reach());
  double cells = 0.0;
  forEachCell(truth.geometry, [&](Cell c) {
    cells += covered[c] != 0 && truth[c] == CellState::kFree ? 1.0 : 0.0;
  });
  return cells * truth.geometry.resolution() * truth.geometry.resolution();
}

}  // namespace

ExplorationScorer::ExplorationScorer(const FloorPlan& plan, const Position& start)
    : truth_(toStates(plan)),
      truth_m2_(coverableArea(truth_, start)),
      navigation_(truth_, placesOf(truth_, start), kSample) {}

ExplorationScore ExplorationScorer::scoreOf(const Snapshot& map) const {
  const ExplorationView view = viewOf(map);
  ExplorationScore score;
  score.truth_m2 = truth_m2_;
  const GridGeometry& geometry = view.states.geometry;
  const double area = geometry.resolution() * geometry.resolution();
  forEachCell(geometry, [&](Cell c) {
    if (view.states[c] == CellState::kFree) {
      const Cell at = truth_.geometry.cellAt(geometry.centre(c));
      const bool free = truth_.geometry.contains(at) && truth_[at] == CellState::kFree;
      (free ? score.known_m2 : score.wrong_m2) += area;
    }
  });
  score.all = navigation_.metricsOf(view.states, view.occupied);
  score.own = NavigationEvaluation(truth_, view.way, kSample).metricsOf(view.states, view.occupied);
  return score;
}

}  // namespace sfw
