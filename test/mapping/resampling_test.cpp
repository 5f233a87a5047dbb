#include "mapping/resampling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "grid/for_each_cell.h"

namespace sfw {
namespace {

const GridGeometry kBuilding(0.1, {-1.3, 0.4}, 31, 23);

Grid<float> noise(std::uint64_t seed) {
  Grid<float> values(kBuilding);
  Random random(seed, 1, 1);
  for (float& value : values.cells) {
    value = static_cast<float>(random.uniform());
  }
  return values;
}

/// The interpolated value at one position, in the order of operations of onMap.
float plainValue(const Grid<float>& values, float outside, const Position& position) {
  const Position at = values.geometry.toCells(position) - Position(0.5, 0.5);
  const Cell low{static_cast<std::int64_t>(std::floor(at.x())),
                 static_cast<std::int64_t>(std::floor(at.y()))};
  const auto x = static_cast<float>(at.x() - static_cast<double>(low.x));
  const auto y = static_cast<float>(at.y() - static_cast<double>(low.y));
  const auto value = [&](std::int64_t dx, std::int64_t dy) {
    const Cell c{low.x + dx, low.y + dy};
    return values.geometry.contains(c) ? values[c] : outside;
  };
  return (1.0F - y) * ((1.0F - x) * value(0, 0) + x * value(1, 0)) +
         y * ((1.0F - x) * value(0, 1) + x * value(1, 1));
}

TEST(OnMap, HasTheBytesOfPlainInterpolation) {
  const Grid<float> one = noise(1);
  const Grid<float> other = noise(2);
  for (const double yaw_rad : {0.0, 0.3, -0.7}) {
    const BuildingFrame frame{yaw_rad, BuildingFrame::Source::kHeadings};
    // It reaches beyond the building on all sides.
    const GridGeometry map(0.05, {-3.0, -3.0}, 140, 150);
    const std::vector<Grid<float>> results = onMap(map, {{one, 0.5F}, {other, -2.0F}}, frame);
    ASSERT_EQ(results.size(), 2U);
    const Eigen::Matrix2d to_building = frame.toBuildingAxes();
    forEachCell(map, [&](Cell c) {
      const Position position = to_building * map.centre(c);
      ASSERT_EQ(results[0][c], plainValue(one, 0.5F, position));
      ASSERT_EQ(results[1][c], plainValue(other, -2.0F, position));
    });
  }
}

}  // namespace
}  // namespace sfw
