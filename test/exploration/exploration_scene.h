#pragma once

#include <limits>

#include "grid/for_each_cell.h"
#include "structure_from_wifi/exploration.h"

namespace sfw::test {

/// A map of 10 x 10 m around the origin of which only a square is known to be free.
inline ExplorationView knownSquare(double half_m) {
  const GridGeometry geometry(0.05, Position(-5.0, -5.0), 200, 200);
  ExplorationView view{Grid<CellState>(geometry, CellState::kUnknown),
                       Grid<float>(geometry, std::numeric_limits<float>::quiet_NaN()),
                       {}};
  forEachCell(geometry, [&](Cell c) {
    if (geometry.centre(c).cwiseAbs().maxCoeff() < half_m) {
      view.states[c] = CellState::kFree;
      view.occupied[c] = 0.02F;
    }
  });
  return view;
}

/// Touches of a robot of 0.15 m all along a line, each from the given side.
/// @param step  from one touch to the next [m]
inline void touchAlong(ExplorationView& view, const Position& from, const Position& to,
                       const Position& side, double step = 0.1) {
  const Position along = to - from;
  for (double s = 0.0; s <= along.norm(); s += step) {
    const Position point = from + s * along.normalized();
    view.touches.push_back({point + 0.15 * side, point});
  }
}

}  // namespace sfw::test
