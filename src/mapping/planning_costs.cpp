#include "structure_from_wifi/planning_costs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "grid/for_each_cell.h"

namespace sfw {
namespace {

/// The cells within a distance of a cell, relative to it.
std::vector<Cell> disc(double radius_cells) {
  const auto reach = static_cast<std::int64_t>(radius_cells);
  std::vector<Cell> cells;
  forEachCell({-reach, -reach}, {reach, reach}, [&](Cell c) {
    if (static_cast<double>(c.x * c.x + c.y * c.y) <= radius_cells * radius_cells) {
      cells.push_back(c);
    }
  });
  return cells;
}

/// The highest probability around a cell of being occupied. Cells without evidence do not count.
float riskAt(const BeliefMap& probability, Cell centre, const std::vector<Cell>& around) {
  float risk = 0.0F;
  for (const Cell offset : around) {
    const Cell c{centre.x + offset.x, centre.y + offset.y};
    if (probability.geometry().contains(c) && probability.known(c)) {
      risk = std::max(risk, probability.occupied(c));
    }
  }
  return risk;
}

std::int8_t costOf(float risk) {
  constexpr float kHighRisk = 0.25F;
  const float share = std::min(risk / kHighRisk, 1.0F);
  return static_cast<std::int8_t>(std::lround(static_cast<float>(kDearestCost) * share));
}

}  // namespace

Grid<std::int8_t> planningCosts(const Snapshot& snapshot, double footprint_radius_m) {
  // The readings do not place a wall better, and a robot does not follow its plan better.
  constexpr double kDeviation = 0.15;  // [m]
  const GridGeometry& geometry = snapshot.belief.geometry();
  const std::vector<Cell> around = disc((footprint_radius_m + kDeviation) / geometry.resolution());
  Grid<std::int8_t> costs(geometry, kUnknownCost);
  forEachCell(geometry, [&](Cell c) {
    const CellState state = snapshot.belief.state(c);
    if (state == CellState::kOccupied) {
      costs[c] = kOccupiedCost;
    } else if (state == CellState::kFree) {
      costs[c] = costOf(riskAt(snapshot.probability, c, around));
    }
  });
  return costs;
}

}  // namespace sfw
