#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw::test {

/// Numbers of a grid's cells, top row first.
using Table = std::vector<std::vector<double>>;

/// A tolerance of half a unit of the third decimal, because expected numbers were calculated by
/// hand.
constexpr double kByHand = 0.0006;

inline void expectTable(const Grid<float>& values, const Table& table, double tolerance = kByHand) {
  const GridGeometry& geometry = values.geometry;
  ASSERT_EQ(static_cast<std::int64_t>(table.size()), geometry.height());
  for (std::int64_t row = 0; row < geometry.height(); ++row) {
    const std::vector<double>& expected = table[static_cast<std::size_t>(row)];
    ASSERT_EQ(static_cast<std::int64_t>(expected.size()), geometry.width());
    for (std::int64_t x = 0; x < geometry.width(); ++x) {
      EXPECT_NEAR(static_cast<double>(values[Cell{x, geometry.height() - 1 - row}]),
                  expected[static_cast<std::size_t>(x)], tolerance)
          << "column " << x << ", row " << row << " from the top";
    }
  }
}

/// Checks a feature that is the same in all rows of a picture.
inline void expectEachRow(const Grid<float>& values, const std::vector<double>& row,
                          double tolerance = kByHand) {
  expectTable(values, Table(static_cast<std::size_t>(values.geometry.height()), row), tolerance);
}

}  // namespace sfw::test
