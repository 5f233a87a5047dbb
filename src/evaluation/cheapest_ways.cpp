#include "evaluation/cheapest_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "grid/dijkstra.h"

namespace sfw {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<Cell, 8> kSteps{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

double lengthOf(Cell step) {
  constexpr double kDiagonal = 1.41421356237309505;
  return step.x != 0 && step.y != 0 ? kDiagonal : 1.0;
}

}  // namespace

CheapestWays::CheapestWays(const Grid<double>& cost_of_cell)
    : cost_of_cell_(cost_of_cell),
      cost_(cost_of_cell.geometry, kInfinity),
      arrived_by_(cost_of_cell.geometry) {}

void CheapestWays::search(Cell start, std::vector<Cell> goals) {
  for (const Cell c : touched_) {
    cost_[c] = kInfinity;
  }
  touched_.clear();
  if (!(cost_of_cell_[start] > 0.0)) {
    return;
  }
  Dijkstra<double> open(cost_);
  open.lower(start, 0.0);
  touched_.push_back(start);
  while (!goals.empty()) {
    const std::optional<Cell> settled = open.settle();
    if (!settled) {
      return;
    }
    goals.erase(std::remove(goals.begin(), goals.end(), *settled), goals.end());
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      const Cell next{settled->x + kSteps[i].x, settled->y + kSteps[i].y};
      if (!cost_.geometry.contains(next) || !(cost_of_cell_[next] > 0.0)) {
        continue;
      }
      const double mean = 0.5 * (cost_of_cell_[*settled] + cost_of_cell_[next]);
      if (open.lower(next, cost_[*settled] + mean * lengthOf(kSteps[i]))) {
        arrived_by_[next] = static_cast<std::uint8_t>(i);
        touched_.push_back(next);
      }
    }
  }
}

std::optional<double> CheapestWays::costTo(Cell goal) const {
  return cost_[goal] < kInfinity ? std::optional(cost_[goal]) : std::nullopt;
}

std::vector<Cell> CheapestWays::to(Cell goal) const {
  std::vector<Cell> way;
  if (!costTo(goal)) {
    return way;
  }
  for (way.push_back(goal); cost_[way.back()] > 0.0;) {
    const Cell at = way.back();
    const Cell step = kSteps[arrived_by_[at]];
    way.push_back({at.x - step.x, at.y - step.y});
  }
  std::reverse(way.begin(), way.end());
  return way;
}

double lengthOf(const std::vector<Cell>& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length += lengthOf(Cell{way[i].x - way[i - 1].x, way[i].y - way[i - 1].y});
  }
  return length;
}

}  // namespace sfw
