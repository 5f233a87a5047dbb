#include "mapping/resampling.h"

#include <cstddef>
#include <cstdint>

#include "base/function_versions.h"

namespace sfw {
namespace {

/// The places of a row of map cells among the cells of a building's grid.
struct Row {
  std::vector<double> along_x, along_y;  // by column: what it adds to the coordinates [m]
  std::vector<std::int32_t> x, y;        // the lower left one of the four nearest cells
  std::vector<float> right, up;          // weights of the right and upper ones of the four
};

/// The largest whole number that is not larger. Unlike std::floor, it is no call of a library.
inline std::int32_t wholeBelow(double value) {
  const auto whole = static_cast<std::int32_t>(value);
  return whole - (static_cast<double>(whole) > value ? 1 : 0);
}

/// Splits the coordinates of a row's cells along one axis into whole cells and weights.
/// @param across  what the row adds to the coordinates [m]
SFW_FUNCTION_VERSIONS
void split(const double* along, double across, double origin, double resolution, std::size_t count,
           std::int32_t* low, float* weight) {
  for (std::size_t i = 0; i < count; ++i) {
    const double at = (along[i] + across - origin) / resolution - 0.5;
    low[i] = wholeBelow(at);
    weight[i] = static_cast<float>(at - static_cast<double>(low[i]));
  }
}

/// The interpolated value of one place. Most places lie within the grid with all four cells.
float valueAt(const BuildingRaster& raster, std::int64_t x, std::int64_t y, float right, float up) {
  const GridGeometry& geometry = raster.values.geometry;
  float value[2][2];
  if (x >= 0 && y >= 0 && x + 1 < geometry.width() && y + 1 < geometry.height()) {
    const float* const lower = raster.values.cells.data() + geometry.index({x, y});
    const float* const upper = lower + geometry.width();
    value[0][0] = lower[0];
    value[0][1] = lower[1];
    value[1][0] = upper[0];
    value[1][1] = upper[1];
  } else {
    for (std::int64_t dy = 0; dy < 2; ++dy) {
      for (std::int64_t dx = 0; dx < 2; ++dx) {
        const Cell c{x + dx, y + dy};
        value[dy][dx] = geometry.contains(c) ? raster.values[c] : raster.outside;
      }
    }
  }
  return (1.0F - up) * ((1.0F - right) * value[0][0] + right * value[0][1]) +
         up * ((1.0F - right) * value[1][0] + right * value[1][1]);
}

}  // namespace

std::vector<Grid<float>> onMap(const GridGeometry& map, const std::vector<BuildingRaster>& rasters,
                               const BuildingFrame& frame) {
  const GridGeometry& building = rasters.front().values.geometry;
  const Eigen::Matrix2d turn = frame.toBuildingAxes();
  const auto width = static_cast<std::size_t>(map.width());
  Row row{std::vector<double>(width),       std::vector<double>(width),
          std::vector<std::int32_t>(width), std::vector<std::int32_t>(width),
          std::vector<float>(width),        std::vector<float>(width)};
  for (std::size_t i = 0; i < width; ++i) {
    const double x = map.centre({static_cast<std::int64_t>(i), 0}).x();
    row.along_x[i] = turn(0, 0) * x;
    row.along_y[i] = turn(1, 0) * x;
  }
  std::vector<Grid<float>> results(rasters.size(), Grid<float>(map));
  for (std::int64_t line = 0; line < map.height(); ++line) {
    const double y = map.centre({0, line}).y();
    const Position& origin = building.origin();
    split(row.along_x.data(), turn(0, 1) * y, origin.x(), building.resolution(), width,
          row.x.data(), row.right.data());
    split(row.along_y.data(), turn(1, 1) * y, origin.y(), building.resolution(), width,
          row.y.data(), row.up.data());
    for (std::size_t k = 0; k < rasters.size(); ++k) {
      float* const to = results[k].cells.data() + map.index({0, line});
      for (std::size_t i = 0; i < width; ++i) {
        to[i] = valueAt(rasters[k], row.x[i], row.y[i], row.right[i], row.up[i]);
      }
    }
  }
  return results;
}

}  // namespace sfw
