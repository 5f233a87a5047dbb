#include "grid/axis_rasters.h"

#include <algorithm>

#include "grid/morphology.h"

namespace sfw {

namespace {

/// Means over `2 * reach + 1` cells of each line; its cells are cell(line, 0..length - 1).
template <typename CellAt>
Grid<float> lineMean(const Grid<float>& values, std::int64_t lines, std::int64_t length,
                     std::int64_t reach, CellAt&& cell) {
  Grid<float> mean(values.geometry);
  const auto window = static_cast<double>(2 * reach + 1);
  for (std::int64_t line = 0; line < lines; ++line) {
    double sum = 0.0;
    for (std::int64_t i = -reach; i < length; ++i) {
      sum += i + reach < length ? static_cast<double>(values[cell(line, i + reach)]) : 0.0;
      sum -= i - reach - 1 >= 0 ? static_cast<double>(values[cell(line, i - reach - 1)]) : 0.0;
      if (i >= 0) {
        mean[cell(line, i)] = static_cast<float>(sum / window);
      }
    }
  }
  return mean;
}

}  // namespace

Grid<float> rowMean(const Grid<float>& values, std::int64_t reach) {
  return lineMean(values, values.geometry.height(), values.geometry.width(), reach,
                  [](auto line, auto i) {
                    return Cell{i, line};
                  });
}

Grid<float> columnMean(const Grid<float>& values, std::int64_t reach) {
  return lineMean(values, values.geometry.width(), values.geometry.height(), reach,
                  [](auto line, auto i) {
                    return Cell{line, i};
                  });
}

Grid<float> boxMean(const Grid<float>& values, std::int64_t reach) {
  return columnMean(rowMean(values, reach), reach);
}

std::array<Grid<float>, 4> axisDistances(const Mask& set, float farthest_m) {
  const GridGeometry& geometry = set.geometry;
  const auto step = static_cast<float>(geometry.resolution());
  std::array<Grid<float>, 4> distance{Grid<float>(geometry), Grid<float>(geometry),
                                      Grid<float>(geometry), Grid<float>(geometry)};
  const auto sweep = [&](Grid<float>& out, std::int64_t lines, std::int64_t length, auto&& cell) {
    for (std::int64_t line = 0; line < lines; ++line) {
      float since = farthest_m;
      for (std::int64_t i = 0; i < length; ++i) {
        const Cell c = cell(line, i);
        since = set[c] != 0 ? 0.0F : std::min(since + step, farthest_m);
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
      // The sum consists of ones. Below a half it is zero in spite of rounding.
      const auto window = static_cast<float>((2 * reach + 1) * (2 * reach + 1));
      result.cells[i] = mean.cells[i] * window > 0.5F ? 1 : 0;
    }
    return result;
  };
  return complement(grown(complement(grown(set))));
}

}  // namespace sfw
