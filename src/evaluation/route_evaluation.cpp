#include "evaluation/route_evaluation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/random.h"
#include "base/random_streams.h"
#include "evaluation/cheapest_ways.h"
#include "evaluation/samples.h"
#include "grid/distance_transform.h"
#include "grid/morphology.h"

namespace sfw {
namespace {

constexpr double kRadius = 0.15;        // [m] of the robot
constexpr double kNearPath = 2.0;       // [m] from places to the path
constexpr double kLeastRoute = 2.0;     // [m]
constexpr double kMove = 0.5;           // [m] of an end that cannot be entered
constexpr double kLongDetour = 1.0;     // [m]
constexpr double kScratch = 1.0;        // [m] around a wall that was not crossed
constexpr double kScratchMargin = 1.5;  // [m] around the places where a plan leaves and returns
constexpr std::size_t kRoutesOfStart = 5;
constexpr int kTries = 1000;  // to draw a place far enough away

double distanceBetween(Cell a, Cell b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y));
}

/// The largest part of a set that is connected over edges; of equal ones the first.
Mask largestPart(const Mask& set) {
  const Components parts = labelComponents(set);
  std::vector<std::size_t> sizes(static_cast<std::size_t>(parts.count) + 1, 0);
  for (const std::int64_t label : parts.label.cells) {
    sizes[static_cast<std::size_t>(label)] += label != 0 ? 1 : 0;
  }
  const std::int64_t largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  Mask part(set.geometry);
  for (std::size_t i = 0; i < part.cells.size(); ++i) {
    part.cells[i] = largest != 0 && parts.label.cells[i] == largest ? 1 : 0;
  }
  return part;
}

std::vector<Cell> placesOf(const Grid<CellState>& truth, const std::vector<Position>& path) {
  const GridGeometry& geometry = truth.geometry;
  const double resolution = geometry.resolution();
  const Grid<double> clearance =
      distanceTransform(complement(cellsOfState(truth, CellState::kFree)));
  Mask roomy(geometry);
  for (std::size_t i = 0; i < roomy.cells.size(); ++i) {
    const bool free = truth.cells[i] == CellState::kFree;
    roomy.cells[i] = free && clearance.cells[i] * resolution > kRadius + resolution ? 1 : 0;
  }
  Mask on_path(geometry);
  for (const Position& position : path) {
    const Cell c = geometry.cellAt(position);
    if (geometry.contains(c)) {
      on_path[c] = 1;
    }
  }
  const Mask connected = largestPart(roomy);
  const Grid<double> to_path = distanceTransform(on_path);
  std::vector<Cell> places;
  forEachCell(geometry, [&](Cell c) {
    if (connected[c] != 0 && to_path[c] * resolution < kNearPath) {
      places.push_back(c);
    }
  });
  return places;
}

/// A whole number below `count`, from a random one in (0, 1].
std::size_t below(std::size_t count, double random) {
  return std::min(count - 1, static_cast<std::size_t>((1.0 - random) * static_cast<double>(count)));
}

/// The costs of cells for a planner; 0 where it may not go.
Grid<double> costsFor(const Mask& passable, const Mask& obstacles) {
  const double resolution = passable.geometry.resolution();
  const Grid<double> clearance = distanceTransform(obstacles);
  Grid<double> costs(passable.geometry, 0.0);
  for (std::size_t i = 0; i < costs.cells.size(); ++i) {
    const double beyond = clearance.cells[i] * resolution - kRadius;
    if (passable.cells[i] != 0 && beyond >= 0.0) {
      costs.cells[i] = 1.0 + 5.0 * std::exp(-8.0 * beyond);
    }
  }
  return costs;
}

/// The nearest cell that a planner may enter, of several the first in row-major order; nothing if
/// it lies too far away.
std::optional<Cell> nearestPassable(const Grid<double>& costs, Cell to) {
  const double reach = kMove / costs.geometry.resolution();
  const auto steps = static_cast<std::int64_t>(reach);
  std::optional<Cell> nearest;
  double least = reach;
  forEachCell({to.x - steps, to.y - steps}, {to.x + steps, to.y + steps}, [&](Cell c) {
    const double distance = distanceBetween(c, to);
    if (costs.geometry.contains(c) && costs[c] > 0.0 &&
        (distance < least || (!nearest && distance <= least))) {
      nearest = c;
      least = distance;
    }
  });
  return nearest;
}

/// The plan of each route on a map; empty where there is none.
std::vector<std::vector<Cell>> plansFor(const std::vector<RouteEnds>& routes,
                                        const Grid<double>& costs) {
  std::vector<std::vector<Cell>> plans(routes.size());
  CheapestWays ways(costs);
  for (std::size_t begin = 0, end = 0; begin < routes.size(); begin = end) {
    std::vector<std::optional<Cell>> goals;
    std::vector<Cell> reachable;
    for (; end < routes.size() && routes[end].from == routes[begin].from; ++end) {
      goals.push_back(nearestPassable(costs, routes[end].to));
      if (goals.back()) {
        reachable.push_back(*goals.back());
      }
    }
    const std::optional<Cell> start = nearestPassable(costs, routes[begin].from);
    if (!start) {
      continue;
    }
    ways.search(*start, reachable);
    for (std::size_t i = begin; i < end; ++i) {
      plans[i] = goals[i - begin] ? ways.to(*goals[i - begin]) : std::vector<Cell>();
    }
  }
  return plans;
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) {
    return std::nullopt;
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

std::vector<RouteEnds> drawRoutes(const Grid<CellState>& truth, const std::vector<Position>& path,
                                  std::size_t starts) {
  const std::vector<Cell> places = placesOf(truth, path);
  const double least = kLeastRoute / truth.geometry.resolution();
  Random random(0, streamOf(Purpose::kEvaluatedRoutes), 0);
  std::vector<RouteEnds> routes;
  if (places.empty()) {
    return routes;
  }
  for (std::size_t start = 0; start < starts; ++start) {
    const double at = (static_cast<double>(start) + random.uniform()) / static_cast<double>(starts);
    const Cell from = places[below(places.size(), 1.0 - at)];
    for (std::size_t i = 0; i < kRoutesOfStart; ++i) {
      for (int tries = 0; tries < kTries; ++tries) {
        const Cell to = places[below(places.size(), random.uniform())];
        if (distanceBetween(from, to) >= least) {
          routes.push_back({from, to});
          break;
        }
      }
    }
  }
  return routes;
}

RouteEvaluation::RouteEvaluation(const Grid<CellState>& truth, std::vector<RouteEnds> routes)
    : free_(cellsOfState(truth, CellState::kFree)),
      walls_(cellsOfState(truth, CellState::kOccupied)),
      routes_(std::move(routes)) {
  for (const std::vector<Cell>& way : plansFor(routes_, costsFor(free_, complement(free_)))) {
    shortest_.push_back(lengthOf(way));
  }
}

RouteMetrics RouteEvaluation::metricsOf(const Grid<CellState>& map) const {
  const Grid<CellState> states = sampled(map, free_.geometry, CellState::kUnknown);
  const std::vector<std::vector<Cell>> plans = plansFor(
      routes_,
      costsFor(cellsOfState(states, CellState::kFree), cellsOfState(states, CellState::kOccupied)));
  const double long_detour = kLongDetour / free_.geometry.resolution();
  std::array<int, 3> outcomes{};  // how many of each
  std::vector<double> detours;
  int long_detours = 0;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const Outcome outcome = follow(plans[i]);
    ++outcomes.at(static_cast<std::size_t>(outcome));
    if (outcome == Outcome::kReached && shortest_[i] > 0.0) {
      detours.push_back(lengthOf(plans[i]) / shortest_[i]);
      long_detours += lengthOf(plans[i]) - shortest_[i] > long_detour ? 1 : 0;
    }
  }
  const auto share_of = [&](Outcome outcome) {
    return outcomes.at(static_cast<std::size_t>(outcome)) / static_cast<double>(plans.size());
  };
  RouteMetrics metrics{share_of(Outcome::kNoPlan), share_of(Outcome::kThroughWall),
                       share_of(Outcome::kReached), std::nullopt, std::nullopt};
  if (!detours.empty()) {
    metrics.detours_over_1m = long_detours / static_cast<double>(detours.size());
    metrics.detour_median = median(std::move(detours));
  }
  return metrics;
}

RouteEvaluation::Outcome RouteEvaluation::follow(const std::vector<Cell>& plan) const {
  if (plan.empty()) {
    return Outcome::kNoPlan;
  }
  return crossesWall(plan) ? Outcome::kThroughWall : Outcome::kReached;
}

bool RouteEvaluation::crossesWall(const std::vector<Cell>& way) const {
  const auto is_free = [&](Cell c) { return free_[c] != 0; };
  const auto is_wall = [&](Cell c) { return walls_[c] != 0; };
  auto at = std::find_if(way.begin(), way.end(), is_wall);
  while (at != way.end()) {
    const auto back = std::find_if(at, way.end(), is_free);
    const auto left = std::find_if(std::make_reverse_iterator(at), way.rend(), is_free);
    if (back == way.end()) {
      return false;  // it ends outside of free space, as near as the map allows
    }
    if (left != way.rend() && !connectedNearby(*left, *back)) {
      return true;
    }
    at = std::find_if(back, way.end(), is_wall);
  }
  return false;
}

bool RouteEvaluation::connectedNearby(Cell from, Cell to) const {
  const GridGeometry& whole = free_.geometry;
  const double straight = distanceBetween(from, to);
  const auto margin = static_cast<std::int64_t>(kScratchMargin / whole.resolution() + straight);
  const Cell low{std::max<std::int64_t>(std::min(from.x, to.x) - margin, 0),
                 std::max<std::int64_t>(std::min(from.y, to.y) - margin, 0)};
  const Cell high{std::min(std::max(from.x, to.x) + margin, whole.width() - 1),
                  std::min(std::max(from.y, to.y) + margin, whole.height() - 1)};
  Grid<double> window(
      GridGeometry(whole.resolution(), Position::Zero(), high.x - low.x + 1, high.y - low.y + 1));
  forEachCell(window.geometry, [&](Cell c) {
    window[c] = free_[{c.x + low.x, c.y + low.y}] != 0 ? 1.0 : 0.0;
  });
  const Cell goal{to.x - low.x, to.y - low.y};
  CheapestWays ways(window);
  ways.search({from.x - low.x, from.y - low.y}, {goal});
  const std::optional<double> length = ways.costTo(goal);
  return length && *length <= straight + kScratch / whole.resolution();
}

}  // namespace sfw
