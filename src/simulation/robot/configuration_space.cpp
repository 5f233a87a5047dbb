#include "simulation/robot/configuration_space.h"

#include <algorithm>
#include <cmath>

#include "grid/dijkstra.h"
#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "grid/morphology.h"
#include "grid/ray.h"
#include "grid/segment.h"

namespace sfw {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
/// A margin [cells]: requireFree rounds differently, and a free cell here must be free there too.
constexpr double kRounding = 1e-6;

}  // namespace

double distanceToDrive(Cell c, Cell from, Cell to) {
  const Position start = toPosition(from);
  return distanceToSegment(toPosition(c) - start, Position::Zero(), toPosition(to) - start);
}

ConfigurationSpace::ConfigurationSpace(const Grid<CellState>& plan, double radius_m)
    : reach_(radius_m / plan.geometry.resolution() + std::sqrt(0.5) + kRounding),
      clearance_(plan.geometry),
      within_(plan.geometry) {
  const GridGeometry& g = plan.geometry;
  Mask obstacles(g);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    obstacles.cells[i] = plan.cells[i] == CellState::kFree ? 0 : 1;
  }
  clearance_ = distanceTransform(obstacles);
  forEachCell(g, [&](Cell c) {
    const std::int64_t to_edge = std::min({c.x + 1, c.y + 1, g.width() - c.x, g.height() - c.y});
    clearance_[c] = std::min(clearance_[c], static_cast<double>(to_edge));
    within_[c] = clearance_[c] >= reach_ ? 1 : 0;
  });
}

void ConfigurationSpace::keepConnectedTo(Cell start) {
  const Components parts = labelComponents(within_);
  for (std::size_t i = 0; i < within_.cells.size(); ++i) {
    within_.cells[i] = parts.label.cells[i] == parts.label[start] ? 1 : 0;
  }
}

std::optional<Cell> ConfigurationSpace::middle() const {
  const Components parts = labelComponents(within_);
  std::vector<std::size_t> sizes(static_cast<std::size_t>(parts.count) + 1, 0);
  for (const std::int64_t label : parts.label.cells) {
    sizes[static_cast<std::size_t>(label)] += label > 0 ? 1 : 0;
  }
  const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
  std::optional<Cell> best;
  forEachCell(geometry(), [&](Cell c) {
    const bool in_largest = largest > 0 && parts.label[c] == largest;
    if (in_largest && (!best || clearance_[c] > clearance_[*best])) {
      best = c;
    }
  });
  return best;
}

bool ConfigurationSpace::driveable(Cell from, Cell to, double least) const {
  // The largest distance in a cell to its centre. An obstacle nearer to the drive than `least` is
  // nearer than `least` plus this distance to the centre of some crossed cell.
  const double half_diagonal = std::sqrt(0.5);
  bool clear = true;
  const GridGeometry& g = geometry();
  Ray(g, g.centre(from), g.centre(to)).forEachCellWhile([&](Cell c) {
    if (!g.contains(c) || clearance_[c] < least - half_diagonal) {
      clear = false;
    } else if (clearance_[c] < least + half_diagonal + kRounding) {
      clear = clearOfCellsNear(c, from, to, least);
    }
    return clear;
  });
  return clear;
}

bool ConfigurationSpace::clearOfCellsNear(Cell c, Cell from, Cell to, double least) const {
  const auto around = static_cast<std::int64_t>(std::ceil(least)) + 1;
  Cell other;
  for (other.y = c.y - around; other.y <= c.y + around; ++other.y) {
    for (other.x = c.x - around; other.x <= c.x + around; ++other.x) {
      const bool free = geometry().contains(other) && clearance_[other] > 0.0;
      if (!free && distanceToDrive(other, from, to) < least) {
        return false;
      }
    }
  }
  return true;
}

PathFinder::PathFinder(const ConfigurationSpace& space, double comfort)
    : space_(space), comfort_(comfort), cost_(space.geometry(), kFar), before_(space.geometry()) {}

double PathFinder::costOfStep(Cell from, Cell to, double length) const {
  constexpr double kTight = 2.0;  // the acceptable detour to stay away from a wall
  const double clearance = std::min(space_.clearance(from), space_.clearance(to));
  return length * (1.0 + kTight * std::max(0.0, 1.0 - clearance / comfort_));
}

std::vector<Cell> PathFinder::toNearest(Cell from, const std::function<bool(Cell)>& wanted) {
  for (const Cell c : touched_) {
    cost_[c] = kFar;
  }
  touched_.assign(1, from);
  Dijkstra<double> search(cost_);
  search.lower(from, 0.0);
  while (const std::optional<Cell> at = search.settle()) {
    if (wanted(*at)) {
      std::vector<Cell> path{*at};
      while (path.back() != from) {
        path.push_back(before_[path.back()]);
      }
      std::reverse(path.begin(), path.end());
      return path;
    }
    space_.forEachStep(*at, [&](Cell next, double length) {
      if (search.lower(next, cost_[*at] + costOfStep(*at, next, length))) {
        before_[next] = *at;
        touched_.push_back(next);
      }
    });
  }
  return {};
}

void DriveDistance::add(const std::vector<Cell>& places) {
  Dijkstra<double> search(length_);
  for (const Cell c : places) {
    search.lower(c, 0.0);
  }
  while (const std::optional<Cell> at = search.settle()) {
    space_.forEachStep(*at,
                       [&](Cell next, double step) { search.lower(next, length_[*at] + step); });
  }
}

}  // namespace sfw
