#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evaluation/route_evaluation.h"
#include "evaluation/wall_knowledge.h"

namespace sfw {

/// Whether a robot can use a map. A group is absent if the path has no pair of places, or no route.
struct NavigationMetrics {
  std::optional<WallKnowledge> walls;
  std::optional<RouteMetrics> routes;
};

/// How much an evaluation asks. The defaults give shares of routes with a standard error of 1 to
/// 2 %, in seconds.
struct NavigationSample {
  std::size_t most_pairs = 50000;  ///< of places of the path
  std::size_t starts = 200;        ///< of routes
};

/// Asks maps of one place for walls between places of a path, and for routes near it.
///
/// It takes the truth as it is: rooms that the path never entered count too.
/// Nothing depends on the order of the path or on gaps in it. Immutable, so threads may share it.
class NavigationEvaluation {
 public:
  /// @param path  positions [m]
  /// @throw std::invalid_argument if a position or the truth's origin is not finite and below
  /// 1000 km
  NavigationEvaluation(const Grid<CellState>& truth, const std::vector<Position>& path,
                       const NavigationSample& sample = NavigationSample());

  /// @param probabilities  of being occupied; may be absent, then there is no AUC
  NavigationMetrics metricsOf(const Grid<CellState>& map,
                              const std::optional<Grid<float>>& probabilities) const;

  const PlacePairs& pairs() const { return pairs_; }
  const RouteEvaluation& routes() const { return routes_; }

 private:
  PlacePairs pairs_;
  RouteEvaluation routes_;
};

}  // namespace sfw
