#include "belief/shortest_paths.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "belief/cell_features.h"

namespace sfw {

ShortestPaths shortestPathsFrom(const Mask& path, const Grid<double>& distance,
                                const Grid<float>& strength, const std::atomic<bool>& stop) {
  const GridGeometry& geometry = path.geometry;
  const double resolution = geometry.resolution();
  constexpr float kFar = 1e6F;
  ShortestPaths ways{Grid<float>(geometry, kFar), Grid<std::size_t>(geometry)};
  using Entry = std::pair<float, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t i = 0; i < path.cells.size(); ++i) {
    if (path.cells[i] != 0) {
      ways.cost.cells[i] = 0.0F;
      ways.source.cells[i] = i;
      open.emplace(0.0F, i);
    }
  }
  const auto visit = [&](float so_far, std::size_t at, Cell next, double length) {
    if (!geometry.contains(next) || distance[next] * resolution > kMaxDistanceToPath) {
      return;
    }
    const float cost = so_far + static_cast<float>(length) * (1.0F + 2.0F * strength[next]);
    if (cost < ways.cost[next]) {
      ways.cost[next] = cost;
      ways.source[next] = ways.source.cells[at];
      open.emplace(cost, geometry.index(next));
    }
  };
  while (!open.empty() && !stop) {
    const auto [so_far, at] = open.top();
    open.pop();
    if (so_far > ways.cost.cells[at]) {
      continue;
    }
    const Cell c = geometry.cell(at);
    for (const std::int64_t step : {-1, 1}) {
      visit(so_far, at, {c.x + step, c.y}, resolution);
      visit(so_far, at, {c.x, c.y + step}, resolution);
      visit(so_far, at, {c.x + step, c.y + step}, std::sqrt(2.0) * resolution);
      visit(so_far, at, {c.x + step, c.y - step}, std::sqrt(2.0) * resolution);
    }
  }
  return ways;
}

}  // namespace sfw
