#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "grid/morphology.h"

namespace sfw::test {

/// The cells that a route crosses.
inline Mask crossed(const GridGeometry& geometry, const std::vector<Position>& route) {
  Mask mask(geometry);
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const Position leg = route[i + 1] - route[i];
    const int steps = static_cast<int>(leg.norm() / (0.2 * geometry.resolution())) + 1;
    for (int s = 0; s <= steps; ++s) {
      mask[geometry.cellAt(route[i] + leg * s / steps)] = 1;
    }
  }
  return mask;
}

/// Cells farther than a distance [m] from all cells that are not free, centre to centre.
inline Mask freeAwayFromWalls(const Grid<CellState>& plan, double distance) {
  Mask walls(plan.geometry);
  for (std::size_t i = 0; i < walls.cells.size(); ++i) {
    walls.cells[i] = plan.cells[i] == CellState::kFree ? 0 : 1;
  }
  return complement(dilated(walls, distance / plan.geometry.resolution()));
}

/// The free cells that the robot's body can touch, starting from a place.
inline Mask touchable(const Grid<CellState>& plan, const Position& start, double radius) {
  const double resolution = plan.geometry.resolution();
  const double reach = radius + std::sqrt(0.5) * resolution;
  const Components parts = labelComponents(freeAwayFromWalls(plan, reach));
  Mask places(plan.geometry);
  for (std::size_t i = 0; i < places.cells.size(); ++i) {
    places.cells[i] = parts.label.cells[i] == parts.label[plan.geometry.cellAt(start)] ? 1 : 0;
  }
  Mask body = dilated(places, reach / resolution);
  for (std::size_t i = 0; i < body.cells.size(); ++i) {
    body.cells[i] = body.cells[i] != 0 && plan.cells[i] == CellState::kFree ? 1 : 0;
  }
  return body;
}

/// Share of the touchable cells that lie within 1.2 m of a route.
inline double coverage(const Grid<CellState>& plan, const std::vector<Position>& route,
                       double radius) {
  const Mask body = touchable(plan, route.front(), radius);
  const Mask seen = dilated(crossed(plan.geometry, route), 1.2 / plan.geometry.resolution());
  double all = 0.0;
  double covered = 0.0;
  for (std::size_t i = 0; i < body.cells.size(); ++i) {
    all += body.cells[i] != 0 ? 1.0 : 0.0;
    covered += body.cells[i] != 0 && seen.cells[i] != 0 ? 1.0 : 0.0;
  }
  return covered / all;
}

/// Rooms of more than 3 m2 that the robot can reach, divided at doors of up to 0.9 m. Also the
/// number of rooms that a route enters.
inline std::pair<int, int> roomsAndEntered(const Grid<CellState>& plan,
                                           const std::vector<Position>& route, double radius) {
  constexpr double kHalfDoor = 0.45;
  constexpr double kLeastRoom = 3.0;
  constexpr double kSurelySmall = 0.05;  // before it is grown by half a door on each side
  const double resolution = plan.geometry.resolution();
  const Mask body = touchable(plan, route.front(), radius);
  const Mask path = crossed(plan.geometry, route);
  const Components middles = labelComponents(freeAwayFromWalls(plan, kHalfDoor));
  std::pair<int, int> result{0, 0};
  for (std::int64_t room = 1; room <= middles.count; ++room) {
    Mask cells(plan.geometry);
    for (std::size_t i = 0; i < cells.cells.size(); ++i) {
      cells.cells[i] = middles.label.cells[i] == room && body.cells[i] != 0 ? 1 : 0;
    }
    const double middle =
        resolution * resolution *
        static_cast<double>(std::count(cells.cells.begin(), cells.cells.end(), 1));
    if (middle < kSurelySmall) {
      continue;
    }
    const Mask grown = middle > kLeastRoom ? cells : dilated(cells, kHalfDoor / resolution);
    double area = 0.0;
    bool entered = false;
    for (std::size_t i = 0; i < cells.cells.size(); ++i) {
      area += grown.cells[i] != 0 && body.cells[i] != 0 ? resolution * resolution : 0.0;
      entered = entered || (cells.cells[i] != 0 && path.cells[i] != 0);
    }
    result.first += area > kLeastRoom ? 1 : 0;
    result.second += area > kLeastRoom && entered ? 1 : 0;
  }
  return result;
}

}  // namespace sfw::test
