#pragma once

#include <cstdint>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw::test {

/// Two rooms of 1.5 m x 2 m, of cells of 0.1 m, with a wall of 0.1 m in the column x = 16.
/// The wall stands from row 1 to `wall_top`; above it is a door up to row 20.
inline Grid<CellState> twoRooms(std::int64_t wall_top = 12) {
  Grid<CellState> rooms(GridGeometry(0.1, Position::Zero(), 33, 22), CellState::kFree);
  for (std::int64_t x = 0; x < 33; ++x) {
    rooms[{x, 0}] = rooms[{x, 21}] = CellState::kOccupied;
  }
  for (std::int64_t y = 0; y < 22; ++y) {
    rooms[{0, y}] = rooms[{32, y}] = CellState::kOccupied;
    if (y <= wall_top) {
      rooms[{16, y}] = CellState::kOccupied;
    }
  }
  return rooms;
}

}  // namespace sfw::test
