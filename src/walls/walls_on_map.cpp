#include "walls/walls_on_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "grid/ray.h"

namespace sfw {
namespace {

/// The cells on the map that a wall crosses, in order.
std::vector<Cell> traceOnMap(const StripWall& wall, const GridGeometry& building,
                             const BuildingFrame& frame, const GridGeometry& map) {
  std::vector<Cell> trace;
  for (std::size_t i = 1; i < wall.cells.size(); ++i) {
    const Position from = frame.toMap(building.centre(wall.cells[i - 1]));
    const Position to = frame.toMap(building.centre(wall.cells[i]));
    Ray(map, from, to).forEachCell([&](Cell c) {
      if (map.contains(c) && (trace.empty() || trace.back() != c)) {
        trace.push_back(c);
      }
    });
  }
  return trace;
}

}  // namespace

Mask wallsOnMap(const std::vector<StripWall>& found, const GridGeometry& building,
                const BuildingFrame& frame, const Mask& open) {
  constexpr double kBesideDoor = 0.15;  // [m]
  const auto margin = std::lround(kBesideDoor / open.geometry.resolution());
  Mask walls(open.geometry);
  for (const StripWall& wall : found) {
    if (wall.is_outer) {
      continue;
    }
    const std::vector<Cell> trace = traceOnMap(wall, building, frame, open.geometry);
    for (auto cell = trace.begin(); cell != trace.end(); ++cell) {
      const auto before = std::min<std::ptrdiff_t>(margin, cell - trace.begin());
      const auto after = std::min<std::ptrdiff_t>(margin + 1, trace.end() - cell);
      walls[*cell] |=
          std::none_of(cell - before, cell + after, [&](Cell c) { return open[c] != 0; });
    }
  }
  return walls;
}

}  // namespace sfw
