#include "axis_rasters.h"

#include <algorithm>

#include "structure_from_wifi/morphology.h"

namespace sfw {

Grid<float> boxMean(const Grid<float>& values, std::int64_t reach) {
  const GridGeometry& geometry = values.geometry;
  Grid<float> rows(geometry);
  Grid<float> mean(geometry);
  const auto window = static_cast<float>(2 * reach + 1);
  for (std::int64_t y = 0; y < geometry.height(); ++y) {
    float sum = 0.0F;
    for (std::int64_t x = -reach; x < geometry.width(); ++x) {
      sum += x + reach < geometry.width() ? values[{x + reach, y}] : 0.0F;
      sum -= x - reach - 1 >= 0 ? values[{x - reach - 1, y}] : 0.0F;
      if (x >= 0) {
        rows[{x, y}] = sum / window;
      }
    }
  }
  for (std::int64_t x = 0; x < geometry.width(); ++x) {
    float sum = 0.0F;
    for (std::int64_t y = -reach; y < geometry.height(); ++y) {
      sum += y + reach < geometry.height() ? rows[{x, y + reach}] : 0.0F;
      sum -= y - reach - 1 >= 0 ? rows[{x, y - reach - 1}] : 0.0F;
      if (y >= 0) {
        mean[{x, y}] = sum / window;
      }
    }
  }
  return mean;
}

std::array<Grid<float>, 4> axisDistances(const Mask& set, float farthest) {
  const GridGeometry& geometry = set.geometry;
  const auto step = static_cast<float>(geometry.resolution());
  std::array<Grid<float>, 4> distance{Grid<float>(geometry), Grid<float>(geometry),
                                      Grid<float>(geometry), Grid<float>(geometry)};
  const auto sweep = [&](Grid<float>& out, std::int64_t lines, std::int64_t length, auto&& cell) {
    for (std::int64_t line = 0; line < lines; ++line) {
      float since = farthest;
      for (std::int64_t i = 0; i < length; ++i) {
        const Cell c = cell(line, i);
        since = set[c] != 0 ? 0.0F : std::min(since + step, farthest);
        out[c] = since;
      }
    }
  };
  const std::int64_t width = geometry.width();
  const std::int64_t height = geometry.height();
  sweep(distance[0], height, width, [](auto line, auto i) { return Cell{i, line}; });
  sweep(distance[1], height, width, [&](auto line, auto i) { return Cell{width - 1 - i, line}; });
  sweep(distance[2], width, height, [](auto line, auto i) { return Cell{line, i}; });
  sweep(distance[3], width, height, [&](auto line, auto i) { return Cell{line, height - 1 - i}; });
  return distance;
}

Mask closedWithSquare(const Mask& set, std::int64_t reach) {
  const GridGeometry& geometry = set.geometry;
  const auto grown = [&](const Mask& mask) {
    Grid<float> values(geometry);
    std::copy(mask.cells.begin(), mask.cells.end(), values.cells.begin());
    const Grid<float> mean = boxMean(values, reach);
    Mask result(geometry);
    for (std::size_t i = 0; i < mean.cells.size(); ++i) {
      // Sums of ones: half a cell's share tells none from one whatever the rounding.
      const auto window = static_cast<float>((2 * reach + 1) * (2 * reach + 1));
      result.cells[i] = mean.cells[i] * window > 0.5F ? 1 : 0;
    }
    return result;
  };
  return complement(grown(complement(grown(set))));
}

}  // namespace sfw
