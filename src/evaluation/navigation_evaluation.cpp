#include "evaluation/navigation_evaluation.h"

namespace sfw {

NavigationEvaluation::NavigationEvaluation(const Grid<CellState>& truth,
                                           const std::vector<Position>& path, std::size_t starts)
    : pairs_(truth, path), routes_(truth, drawRoutes(truth, path, starts)) {}

NavigationMetrics NavigationEvaluation::metricsOf(
    const Grid<CellState>& map, const std::optional<Grid<float>>& probabilities) const {
  NavigationMetrics metrics;
  if (pairs_.count() > 0) {
    metrics.walls = pairs_.knowledgeOf(map, probabilities);
  }
  if (routes_.count() > 0) {
    metrics.routes = routes_.metricsOf(map);
  }
  return metrics;
}

}  // namespace sfw
