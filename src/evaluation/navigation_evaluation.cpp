#include "evaluation/navigation_evaluation.h"

#include "evaluation/evaluation_truth.h"

namespace sfw {

namespace {

const std::vector<Position>& usable(const std::vector<Position>& path,
                                    const Grid<CellState>& truth) {
  requireUsable(path, "path");
  requireUsable({truth.geometry.origin()}, "the truth's origin");
  return path;
}

}  // namespace

NavigationEvaluation::NavigationEvaluation(const Grid<CellState>& truth,
                                           const std::vector<Position>& path,
                                           const NavigationSample& sample)
    : pairs_(truth, usable(path, truth), sample.most_pairs),
      routes_(truth, drawRoutes(truth, path, sample.starts)) {}

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
