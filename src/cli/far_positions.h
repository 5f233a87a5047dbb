#pragma once

#include <string>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The offset that brings the positions of a recording near zero, in steps of 100 m: zero unless
/// the readings lie over 2 km from the frame's origin, as in UTM or a national grid. [m]
///
/// Half of the readings may lie elsewhere. O(readings)
Position offsetOf(const std::vector<Reading>& readings);

/// A point less an offset, rounded to micrometres: a grid far away and its origin near zero agree.
Position near(const Position& point, const Position& offset);

/// Subtracts an offset.
/// @{
template <class T>
Grid<T> near(Grid<T> grid, const Position& offset) {
  const GridGeometry& far = grid.geometry;
  grid.geometry =
      GridGeometry(far.resolution(), near(far.origin(), offset), far.width(), far.height());
  return grid;
}
void subtract(const Position& offset, std::vector<Reading>& readings);
void subtract(const Position& offset, std::vector<AccessPoint>& access_points);
/// @}

/// @throw InputError naming the first access point that is over 2 km from the origin after an
/// offset was subtracted: table and readings have different frames
void requireSameFrame(const Position& offset, const std::vector<AccessPoint>& access_points,
                      const std::string& table_file);

}  // namespace sfw
