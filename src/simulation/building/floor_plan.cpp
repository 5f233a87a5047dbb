#include "simulation/building/floor_plan.h"

#include <algorithm>
#include <vector>

#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "grid/morphology.h"

namespace sfw {
namespace {

constexpr double kThickestOuterWall = 0.5;     // [m]
constexpr double kThickestInteriorWall = 0.4;  // [m]
constexpr double kNarrowestFloor = 0.4;        // an area that is narrower everywhere is a speck [m]

/// The outside, on a grid that is one cell wider on each side. The additional ring is outside, so
/// that a building may fill its own grid.
Mask outsideOf(const Grid<CellState>& states) {
  const GridGeometry& inner = states.geometry;
  const double ring = inner.resolution();
  Mask not_built(GridGeometry(ring, inner.origin() - Position(ring, ring), inner.width() + 2,
                              inner.height() + 2),
                 1);
  forEachCell(inner, [&](Cell c) {
    not_built[{c.x + 1, c.y + 1}] = states[c] == CellState::kUnknown ? 1 : 0;
  });
  const Components components = labelComponents(not_built);
  const std::int64_t of_ring = components.label[{0, 0}];
  for (std::size_t i = 0; i < not_built.cells.size(); ++i) {
    not_built.cells[i] = components.label.cells[i] == of_ring ? 1 : 0;
  }
  return not_built;
}

/// Free cells without the specks that scanners leave behind façades.
Mask floorOf(const Grid<CellState>& states) {
  Mask free(states.geometry);
  Mask walls(states.geometry);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    free.cells[i] = states.cells[i] == CellState::kFree ? 1 : 0;
    walls.cells[i] = free.cells[i] == 0 ? 1 : 0;
  }
  const Grid<double> depth = distanceTransform(walls);
  const Components parts = labelComponents(free);
  std::vector<double> deepest(static_cast<std::size_t>(parts.count) + 1, 0.0);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    double& of_part = deepest[static_cast<std::size_t>(parts.label.cells[i])];
    of_part = std::max(of_part, depth.cells[i]);
  }
  const double least = kNarrowestFloor / 2.0 / states.geometry.resolution();
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    if (deepest[static_cast<std::size_t>(parts.label.cells[i])] < least) {
      free.cells[i] = 0;
    }
  }
  return free;
}

/// The floor and the gaps in it that an interior wall could fill.
///
/// Closing separates the two kinds of walls where they meet. A disc wider than the interior wall
/// cannot enter the gap from the side of the façade. The façade has no floor behind it and stays
/// unchanged.
Mask spaceWithinOuterWalls(const Grid<CellState>& states) {
  return closed(floorOf(states), 0.5 * kThickestInteriorWall / states.geometry.resolution());
}

}  // namespace

Grid<CellState> toStates(const FloorPlan& plan) {
  Grid<CellState> states(plan.geometry);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    switch (plan.cells[i]) {
      case Material::kUnknown:
        states.cells[i] = CellState::kUnknown;
        break;
      case Material::kFree:
        states.cells[i] = CellState::kFree;
        break;
      case Material::kInteriorWall:
      case Material::kOuterWall:
        states.cells[i] = CellState::kOccupied;
        break;
    }
  }
  return states;
}

FloorPlan withMaterials(const Grid<CellState>& states) {
  const Grid<double> to_outside = distanceTransform(outsideOf(states));
  const Mask within = spaceWithinOuterWalls(states);
  const double reach = kThickestOuterWall / states.geometry.resolution();
  FloorPlan plan(states.geometry);
  forEachCell(states.geometry, [&](Cell c) {
    if (states[c] == CellState::kFree) {
      plan[c] = Material::kFree;
    } else if (states[c] == CellState::kOccupied) {
      const bool outer = within[c] == 0 && to_outside[{c.x + 1, c.y + 1}] <= reach;
      plan[c] = outer ? Material::kOuterWall : Material::kInteriorWall;
    }
  });
  return plan;
}

}  // namespace sfw
