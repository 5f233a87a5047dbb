#pragma once

#include <optional>
#include <vector>

#include "evaluation/evaluation.h"
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

/// @throw std::invalid_argument naming the positions if one of them cannot lie in a building.
void requireUsable(const std::vector<Position>& positions, const char* name);

/// @throw as evaluate().
EvaluationTruth makeEvaluationTruth(const Grid<CellState>& truth, const std::vector<Position>& path,
                                    const std::vector<Position>& access_points);

/// The map made from the path alone, without any radio.
Mask pathOnlyFree(const Mask& path);

}  // namespace sfw
