#include "k_visibility/k_visibility.h"

#include <algorithm>
#include <vector>

#include "grid/for_each_cell.h"
#include "grid/ray.h"
#include "k_visibility/cone_sweep.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// @throw InputError if sub-cells could not be counted exactly.
void requireInReach(const Position& source_cells) {
  if (!((source_cells.array().abs() <= static_cast<double>(ConeSweep::kFarthest)).all())) {
    throw InputError("the access point is more than 524288 cells away from the plan");
  }
}

bool isCounted(std::uint8_t value) { return value <= kMostWalls; }

/// Marks the walls on one ray away from the access point.
void followRay(const Grid<std::uint8_t>& k_map, const Ray& ray, bool walls_are_marked,
               std::vector<Cell>& between, Grid<CellState>& plan) {
  int last_count = kNoCount;
  between.clear();
  ray.forEachCell([&](Cell cell) {
    if (!k_map.geometry.contains(cell)) {
      return;
    }
    if (!isCounted(k_map[cell])) {
      if (!walls_are_marked || k_map[cell] == kWallCell) {
        between.push_back(cell);
      }
      return;
    }
    if (k_map[cell] == last_count + 1) {
      for (const Cell wall : between) {
        plan[wall] = CellState::kOccupied;
      }
    }
    last_count = k_map[cell];
    between.clear();
  });
}

bool bordersNoCount(const Grid<std::uint8_t>& k_map, Cell cell) {
  bool borders = false;
  forEachCell(Cell{cell.x - 1, cell.y - 1}, Cell{cell.x + 1, cell.y + 1}, [&](Cell c) {
    borders = borders || (k_map.geometry.contains(c) && !isCounted(k_map[c]));
  });
  return borders;
}

}  // namespace

Grid<std::uint8_t> forwardKVisibility(const Grid<CellState>& plan, const Position& access_point) {
  const GridGeometry& geometry = plan.geometry;
  const Position source = geometry.toCells(access_point);
  requireInReach(source);
  Grid<std::uint8_t> counts(geometry, kNoCount);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (plan.cells[i] == CellState::kOccupied) {
      counts.cells[i] = kWallCell;
    }
  }
  for (const bool along_x : {true, false}) {
    for (const int sign : {1, -1}) {
      ConeSweep(plan, Ray::snapped(source.x()), Ray::snapped(source.y()), along_x, sign)
          .writeTo(counts);
    }
  }
  const Cell source_cell = geometry.cellAt(access_point);
  if (geometry.contains(source_cell) && plan[source_cell] == CellState::kFree) {
    counts[source_cell] = 0;
  }
  return counts;
}

Grid<CellState> denseInverseKVisibility(const Grid<std::uint8_t>& k_map,
                                        const Position& access_point) {
  const GridGeometry& geometry = k_map.geometry;
  Grid<CellState> plan(geometry, CellState::kUnknown);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    plan.cells[i] = isCounted(k_map.cells[i]) ? CellState::kFree : CellState::kUnknown;
  }
  const bool walls_are_marked =
      std::find(k_map.cells.begin(), k_map.cells.end(), kWallCell) != k_map.cells.end();
  std::vector<Cell> between;
  const auto follow = [&](double x, double y) {
    const Position end = geometry.origin() + geometry.resolution() * Position(x, y);
    followRay(k_map, Ray(geometry, access_point, end), walls_are_marked, between, plan);
  };
  // Rays must miss hardly any wall cell.
  constexpr std::int64_t kRaysPerCell = 16;  // of the rim
  const auto along = [](std::int64_t ray) {
    return (static_cast<double>(ray) + 0.5) / static_cast<double>(kRaysPerCell);
  };
  const auto width = static_cast<double>(geometry.width());
  const auto height = static_cast<double>(geometry.height());
  for (std::int64_t ray = 0; ray < kRaysPerCell * geometry.width(); ++ray) {
    follow(along(ray), 0.5);
    follow(along(ray), height - 0.5);
  }
  for (std::int64_t ray = 0; ray < kRaysPerCell * geometry.height(); ++ray) {
    follow(0.5, along(ray));
    follow(width - 0.5, along(ray));
  }
  // One more ray goes to each counted cell beside a cell without a count.
  forEachCell(geometry, [&](Cell c) {
    if (isCounted(k_map[c]) && bordersNoCount(k_map, c)) {
      follow(static_cast<double>(c.x) + 0.5, static_cast<double>(c.y) + 0.5);
    }
  });
  return plan;
}

}  // namespace sfw
