#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "grid/for_each_cell.h"
#include "grid/ray.h"
#include "k_visibility/k_visibility.h"
#include "simulation/building/wall_crossings.h"

namespace sfw::test {

/// Number of runs of wall cells on the ray between two points, except a run that contains the
/// access point.
inline int runsOfWall(const Grid<CellState>& plan, const Position& access_point,
                      const Position& place) {
  int runs = 0;
  bool in_wall = false, first = true;
  Ray(plan.geometry, access_point, place).forEachCell([&](Cell c) {
    const bool wall = plan.geometry.contains(c) && plan[c] == CellState::kOccupied;
    runs += wall && !in_wall && !first ? 1 : 0;
    in_wall = wall;
    first = false;
  });
  return runs;
}

/// The true wall count in a simulated radio.
inline int radioCount(const Grid<CellState>& plan, const Position& access_point,
                      const Position& place) {
  return countWalls(plan, access_point, place);
}

/// Share of free cells whose count equals that of a walk along the ray.
template <class CountOnRay>
double agreement(const Grid<CellState>& plan, const Position& access_point, CountOnRay&& count) {
  const Grid<std::uint8_t> k_map = forwardKVisibility(plan, access_point);
  double free = 0.0, agree = 0.0;
  forEachCell(plan.geometry, [&](Cell c) {
    if (plan[c] == CellState::kFree) {
      free += 1.0;
      const int walls = count(plan, access_point, plan.geometry.centre(c));
      agree += k_map[c] == std::min<int>(walls, kMostWalls) ? 1.0 : 0.0;
    }
  });
  return agree / free;
}

/// Measures how well the inverse of the forward map finds the walls.
struct InverseFigures {
  double found;    ///< share of the wall cells between two consecutive counts on a ray
  double falsely;  ///< share of the cells called wall that are not wall
};

/// Marks the wall cells that a ray meets between two consecutive counts.
inline void markBetween(const Grid<std::uint8_t>& k_map, const Ray& ray, Grid<char>& marked) {
  std::vector<Cell> walls;
  std::optional<int> last;
  ray.forEachCell([&](Cell c) {
    if (!k_map.geometry.contains(c)) {
      return;
    }
    if (k_map[c] == kWallCell) {
      walls.push_back(c);
    } else if (k_map[c] == kNoCount) {
      walls.clear();
      last.reset();
    } else {
      for (const Cell wall : walls) {
        marked[wall] = marked[wall] != 0 || (last && k_map[c] == *last + 1) ? 1 : 0;
      }
      walls.clear();
      last = k_map[c];
    }
  });
}

inline InverseFigures inverseFigures(const Grid<CellState>& plan, const Position& access_point) {
  const Grid<std::uint8_t> k_map = forwardKVisibility(plan, access_point);
  const Grid<CellState> walls = denseInverseKVisibility(k_map, access_point);
  Grid<char> to_find(plan.geometry, 0);
  forEachCell(plan.geometry, [&](Cell c) {
    if (plan[c] == CellState::kFree) {
      markBetween(k_map, Ray(plan.geometry, access_point, plan.geometry.centre(c)), to_find);
    }
  });
  double wanted = 0.0, found = 0.0, called = 0.0, wrong = 0.0;
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    const bool wall = walls.cells[i] == CellState::kOccupied;
    wanted += to_find.cells[i];
    found += to_find.cells[i] != 0 && wall ? 1.0 : 0.0;
    called += wall ? 1.0 : 0.0;
    wrong += wall && plan.cells[i] != CellState::kOccupied ? 1.0 : 0.0;
  }
  return {found / wanted, wrong / std::max(called, 1.0)};
}

}  // namespace sfw::test
