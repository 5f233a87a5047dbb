#include "structure_from_wifi/planning_costs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "grid/for_each_cell.h"

namespace sfw {
namespace {

/// A disc of cells: for each row from the lowest, the cells to either side of the centre's column.
std::vector<std::int64_t> halfWidths(double radius_cells) {
  const auto reach = static_cast<std::int64_t>(radius_cells);
  std::vector<std::int64_t> widths;
  for (std::int64_t y = -reach; y <= reach; ++y) {
    const double square = radius_cells * radius_cells - static_cast<double>(y * y);
    widths.push_back(static_cast<std::int64_t>(std::sqrt(std::max(square, 0.0))));
  }
  return widths;
}

/// The probability of being occupied, 0 where nothing is known.
Grid<float> risksOf(const BeliefMap& probability) {
  Grid<float> risks(probability.geometry());
  forEachCell(risks.geometry,
              [&](Cell c) { risks[c] = probability.known(c) ? probability.occupied(c) : 0.0F; });
  return risks;
}

float highestAround(const Grid<float>& risks, Cell centre, const std::vector<std::int64_t>& disc) {
  const auto reach = static_cast<std::int64_t>(disc.size() / 2);
  float highest = 0.0F;
  for (std::int64_t y = std::max<std::int64_t>(centre.y - reach, 0);
       y <= std::min(centre.y + reach, risks.geometry.height() - 1); ++y) {
    const std::int64_t width = disc[static_cast<std::size_t>(y - centre.y + reach)];
    const std::int64_t left = std::max<std::int64_t>(centre.x - width, 0);
    const std::int64_t right = std::min(centre.x + width, risks.geometry.width() - 1);
    const float* const row = &risks[{0, y}];
    highest = std::max(highest, *std::max_element(row + left, row + right + 1));
  }
  return highest;
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
  const std::vector<std::int64_t> disc =
      halfWidths((footprint_radius_m + kDeviation) / geometry.resolution());
  const Grid<float> risks = risksOf(snapshot.probability);
  Grid<std::int8_t> costs(geometry, kUnknownCost);
  forEachCell(geometry, [&](Cell c) {
    const CellState state = snapshot.belief.state(c);
    if (state == CellState::kOccupied) {
      costs[c] = kOccupiedCost;
    } else if (state == CellState::kFree) {
      costs[c] = costOf(highestAround(risks, c, disc));
    }
  });
  return costs;
}

}  // namespace sfw
