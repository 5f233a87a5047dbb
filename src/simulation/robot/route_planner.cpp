#include "simulation/robot/route_planner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_map>

#include "base/validation.h"
#include "grid/for_each_cell.h"
#include "simulation/robot/configuration_space.h"
#include "simulation/robot/route_strokes.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Drops the cells of a path between two others if the straight drive between those is good.
///
/// Greedy: doubling and halving find the longest good stretch. So the number of tests is
/// logarithmic in the cells of a stretch.
/// @param good  (from, to): of two indices, whether the drive between them may replace all between
template <class Good>
void appendSimplified(const std::vector<Cell>& cells, Good&& good, std::vector<Cell>& route) {
  std::size_t at = 0;
  while (at + 1 < cells.size()) {
    std::size_t step = 1;
    std::size_t next = at + 1;
    while (next + step < cells.size() && good(at, next + step)) {
      next += step;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (next + step < cells.size() && good(at, next + step)) {
        next += step;
      }
    }
    route.push_back(cells[next]);
    at = next;
  }
}

/// Drives all strokes, one after the other.
class Driver {
 public:
  Driver(const ConfigurationSpace& space, double comfort, Cell start,
         const std::vector<Stroke>& strokes)
      : space_(space),
        comfort_(comfort),
        finder_(space, comfort),
        strokes_(strokes),
        driven_(strokes.size(), false),
        route_{start} {
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      const std::vector<Cell>& cells = strokes[i].cells;
      if (strokes[i].closed) {
        for (const Cell c : cells) {
          addEntry(c, i);
        }
      } else {
        addEntry(cells.front(), i);
        addEntry(cells.back(), i);
      }
    }
  }

  /// @return way points, no two successive ones the same.
  std::vector<Cell> drive() {
    std::int64_t room = 0;
    for (std::size_t left = strokes_.size(); left > 0; --left) {
      room = anyLeftIn(room) ? room : 0;
      const std::vector<Cell> path = finder_.toNearest(
          route_.back(), [&](Cell c) { return strokeAt(c, room) < strokes_.size(); });
      if (path.empty()) {
        break;  // cannot be: strokes lie in a connected space
      }
      const std::size_t stroke = strokeAt(path.back(), room);
      appendConnection(path);
      appendStroke(strokes_[stroke]);
      driven_[stroke] = true;
      room = strokes_[stroke].room;
    }
    route_.erase(std::unique(route_.begin(), route_.end()), route_.end());
    return route_;
  }

 private:
  void addEntry(Cell c, std::size_t stroke) {
    entries_[space_.geometry().index(c)].push_back(stroke);
  }

  bool anyLeftIn(std::int64_t room) const {
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      if (!driven_[i] && room != 0 && strokes_[i].room == room) {
        return true;
      }
    }
    return false;
  }

  /// A stroke that may start at a cell and is not driven yet, or the number of strokes if there is
  /// none.
  /// @param room  that it must be in, unless 0
  std::size_t strokeAt(Cell c, std::int64_t room) const {
    const auto found = entries_.find(space_.geometry().index(c));
    if (found != entries_.end()) {
      for (const std::size_t stroke : found->second) {
        if (!driven_[stroke] && (room == 0 || strokes_[stroke].room == room)) {
          return stroke;
        }
      }
    }
    return strokes_.size();
  }

  /// A shortcut comes no nearer to walls than the replaced path, or than the comfortable clearance.
  void appendConnection(const std::vector<Cell>& path) {
    appendSimplified(
        path,
        [&](std::size_t from, std::size_t to) {
          double least = comfort_;
          for (std::size_t i = from; i <= to; ++i) {
            least = std::min(least, space_.clearance(path[i]));
          }
          return space_.driveable(path[from], path[to], std::max(least, space_.reach()));
        },
        route_);
  }

  /// Appends a stroke from its entry, which the route has reached.
  void appendStroke(const Stroke& stroke) {
    std::vector<Cell> cells = stroke.cells;
    if (stroke.closed) {
      std::rotate(cells.begin(), std::find(cells.begin(), cells.end(), route_.back()), cells.end());
      cells.push_back(cells.front());
    } else if (cells.front() != route_.back()) {
      std::reverse(cells.begin(), cells.end());
    }
    const std::vector<bool> corners = cornersOf(cells);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (corners[i]) {
        route_.push_back(cells[i]);
      }
    }
  }

  /// The cells at which a stroke turns, by Douglas and Peucker's method. It finds the corners of
  /// rooms.
  std::vector<bool> cornersOf(const std::vector<Cell>& cells) const {
    constexpr double kTolerance = 1.0;  // [cells]
    std::vector<bool> corners(cells.size(), false);
    corners.front() = corners.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, cells.size() - 1}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      double farthest = -1.0;
      std::size_t corner = from;
      for (std::size_t i = from + 1; i < to; ++i) {
        const double distance = distanceToDrive(cells[i], cells[from], cells[to]);
        if (distance > farthest) {
          farthest = distance;
          corner = i;
        }
      }
      const bool straight =
          farthest <= kTolerance && space_.driveable(cells[from], cells[to], space_.reach());
      if (corner != from && !straight) {
        corners[corner] = true;
        open.emplace_back(from, corner);
        open.emplace_back(corner, to);
      }
    }
    return corners;
  }

  const ConfigurationSpace& space_;
  double comfort_;
  PathFinder finder_;
  const std::vector<Stroke>& strokes_;
  std::vector<bool> driven_;
  std::unordered_map<std::size_t, std::vector<std::size_t>> entries_;  // strokes by cell
  std::vector<Cell> route_;
};

Cell chooseStart(const ConfigurationSpace& space, const RoutePlannerConfig& config) {
  char text[128];
  if (!config.start_in_map) {
    const std::optional<Cell> start = space.middle();
    if (!start) {
      std::snprintf(text, sizeof text,
                    "the plan has no free space for a robot of %.2f m radius; lower robot_radius",
                    config.robot_radius_m);
      throw InputError(text);
    }
    return *start;
  }
  const Cell start = space.geometry().cellAt(*config.start_in_map);
  if (!space.contains(start)) {
    std::snprintf(text, sizeof text, "start (%.2f, %.2f) is not free for a robot of %.2f m radius",
                  config.start_in_map->x(), config.start_in_map->y(), config.robot_radius_m);
    throw InputError(text);
  }
  return start;
}

/// Adds the cell farthest from the start if a route has only one cell.
std::vector<Cell> withSomewhereToGo(std::vector<Cell> route, const ConfigurationSpace& space) {
  if (route.size() > 1) {
    return route;
  }
  DriveDistance distance(space);
  distance.add(route);
  Cell farthest = route.front();
  forEachCell(space.geometry(), [&](Cell c) {
    if (space.contains(c) && distance[c] > distance[farthest]) {
      farthest = c;
    }
  });
  if (farthest == route.front()) {
    throw InputError("the robot cannot move from its start; lower robot_radius");
  }
  return PathFinder(space, space.reach()).toNearest(route.front(), [&](Cell at) {
    return at == farthest;
  });
}

}  // namespace

std::optional<RouteKind> parseRouteKind(std::string_view name) {
  if (name == "walls") {
    return RouteKind::kWalls;
  }
  return name == "sparse" ? std::optional(RouteKind::kSparse) : std::nullopt;
}

std::vector<std::string> validate(const RoutePlannerConfig& config) {
  Problems problems;
  problems.within("robot_radius", config.robot_radius_m, 0.01, 5.0, "m");
  problems.within("clearance", config.clearance_m, 0.0, 5.0, "m");
  if (config.start_in_map && !(config.start_in_map->array().abs() <= 1e6).all()) {
    problems.add("start must be finite and within 1000 km of the origin");
  }
  return problems.list();
}

std::vector<Position> planRoute(const Grid<CellState>& plan, RouteKind kind,
                                const RoutePlannerConfig& config) {
  throwIfAny(validate(config));
  ConfigurationSpace space(plan, config.robot_radius_m);
  const Cell start = chooseStart(space, config);
  space.keepConnectedTo(start);
  // Cells diagonal to cells at this distance are free too, so the robot can follow contours.
  const double distance = std::max(
      (config.robot_radius_m + config.clearance_m) / plan.geometry.resolution(), space.reach());
  const std::vector<Stroke> strokes =
      kind == RouteKind::kWalls ? wallStrokes(space, distance) : patrolStrokes(space, distance);
  const std::vector<Cell> route =
      withSomewhereToGo(Driver(space, distance, start, strokes).drive(), space);
  std::vector<Position> way_points;
  way_points.reserve(route.size());
  for (const Cell c : route) {
    way_points.push_back(plan.geometry.centre(c));
  }
  return way_points;
}

}  // namespace sfw
