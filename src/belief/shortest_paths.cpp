#include "belief/shortest_paths.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include "belief/cell_features.h"
#include "grid/dijkstra.h"

namespace sfw {

ShortestPaths shortestPathsFrom(const Mask& path, const Grid<double>& distance,
                                const Grid<float>& strength, const std::atomic<bool>& stop) {
  const GridGeometry& geometry = path.geometry;
  const double resolution = geometry.resolution();
  constexpr float kFar = 1e6F;
  ShortestPaths ways{Grid<float>(geometry, kFar), Grid<std::size_t>(geometry)};
  BucketDijkstra search(ways.cost, static_cast<float>(resolution));
  for (std::size_t i = 0; i < path.cells.size(); ++i) {
    if (path.cells[i] != 0) {
      search.lower(geometry.cell(i), 0.0F);
      ways.source.cells[i] = i;
    }
  }
  const auto visit = [&](Cell at, Cell next, double length) {
    if (!geometry.contains(next) || distance[next] * resolution > kMaxDistanceToPath) {
      return;
    }
    const float step = static_cast<float>(length) * (1.0F + 2.0F * strength[next]);
    if (search.lower(next, ways.cost[at] + step)) {
      ways.source[next] = ways.source[at];
    }
  };
  while (!stop) {
    const std::optional<Cell> settled = search.settle();
    if (!settled) {
      break;
    }
    const Cell c = *settled;
    for (const std::int64_t step : {-1, 1}) {
      visit(c, {c.x + step, c.y}, resolution);
      visit(c, {c.x, c.y + step}, resolution);
      visit(c, {c.x + step, c.y + step}, std::sqrt(2.0) * resolution);
      visit(c, {c.x + step, c.y - step}, std::sqrt(2.0) * resolution);
    }
  }
  return ways;
}

}  // namespace sfw
