#pragma once

#include <cmath>

#include "base/constants.h"
#include "grid/for_each_cell.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The angle from -pi to pi, or the quarter turn beside it if the difference moves no cell of a
/// grid by half a cell.
inline double snappedYaw(double yaw_rad, const GridGeometry& geometry) {
  const double yaw = std::remainder(yaw_rad, 2.0 * kPi);
  const double quarter = 0.5 * kPi * std::round(yaw / (0.5 * kPi));
  const double reach =
      std::hypot(static_cast<double>(geometry.width()), static_cast<double>(geometry.height()));
  return std::abs(yaw - quarter) * reach < 0.5 ? quarter : yaw;
}

/// Turns a grid about its origin, the lower left corner of its first cell.
///
/// Each cell of the result has the value of the cell in which its centre lies before the turn.
/// Quarter turns are exact; others make jagged edges. Linear in cells of the result.
/// @param yaw_rad  counterclockwise, in [-pi, pi]
/// @param outside  value of cells that no cell is turned to
/// @throw std::invalid_argument if the result is too large for GridGeometry
template <class T>
Grid<T> turned(const Grid<T>& grid, double yaw_rad, const T& outside) {
  constexpr double kRounding = 1e-6;  // [cells]
  const GridGeometry& from = grid.geometry;
  const auto exact = [](double value) { return std::abs(value) < kRounding ? 0.0 : value; };
  const double cosine = exact(std::cos(yaw_rad));
  const double sine = exact(std::sin(yaw_rad));
  Eigen::Matrix2d turn;
  turn << cosine, -sine, sine, cosine;
  Box box;  // [cells], from the origin
  const Position size(static_cast<double>(from.width()), static_cast<double>(from.height()));
  for (const Position& corner :
       {Position(0, 0), Position(size.x(), 0), Position(0, size.y()), size}) {
    box.extend(turn * corner);
  }
  const Position cells = (box.sizes().array() - kRounding).ceil();
  const GridGeometry to(from.resolution(), from.origin() + from.resolution() * box.min(),
                        static_cast<std::int64_t>(cells.x()), static_cast<std::int64_t>(cells.y()));
  Grid<T> result(to, outside);
  forEachCell(to, [&](Cell c) {
    const Position centre(static_cast<double>(c.x) + 0.5, static_cast<double>(c.y) + 0.5);
    const Position before = (turn.transpose() * (box.min() + centre)).array().floor();
    const Cell source{static_cast<std::int64_t>(before.x()), static_cast<std::int64_t>(before.y())};
    if (from.contains(source)) {
      result[c] = grid[source];
    }
  });
  return result;
}

}  // namespace sfw
