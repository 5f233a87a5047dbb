#pragma once

#include <optional>
#include <vector>

#include "evaluation/evaluation.h"
#include "grid/for_each_cell.h"
#include "grid/mask.h"

namespace sfw {

/// The truth as masks on one lattice. See evaluate() for the definitions.
struct EvaluationTruth {
  explicit EvaluationTruth(const GridGeometry& lattice)
      : region(lattice), walls(lattice), known(lattice), occupied(lattice), path(lattice) {}

  const GridGeometry& lattice() const { return region.geometry; }

  Mask region;                   ///< the free component that the path touches
  Mask walls;                    ///< occupied cells that border it
  Mask known;                    ///< cells of known state
  Mask occupied;                 ///< all occupied cells
  Mask path;                     ///< cells that the path crosses
  std::optional<Mask> observed;  ///< cells on a ray; absent without access points
};

/// @throw as evaluate().
EvaluationTruth makeEvaluationTruth(const Grid<CellState>& truth, const std::vector<Position>& path,
                                    const std::vector<Position>& access_points);

/// The map made from the path alone, without any radio.
Mask pathOnlyFree(const Mask& path);

/// The cells of one state.
Mask cellsOfState(const Grid<CellState>& grid, CellState state);

/// The value that a grid of any resolution has at each centre of the lattice's cells.
/// @param elsewhere for centres outside the grid
template <class T>
Grid<T> sampled(const Grid<T>& grid, const GridGeometry& lattice, const T& elsewhere) {
  Grid<T> samples(lattice, elsewhere);
  forEachCell(lattice, [&](Cell c) {
    // Uses floating point, because a grid may lie too far away for integer numbers of cells.
    const Position at = grid.geometry.toCells(lattice.centre(c));
    if (at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(grid.geometry.width()) &&
        at.y() < static_cast<double>(grid.geometry.height())) {
      samples[c] = grid[{static_cast<std::int64_t>(at.x()), static_cast<std::int64_t>(at.y())}];
    }
  });
  return samples;
}

}  // namespace sfw
