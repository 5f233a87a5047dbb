#pragma once

#include <functional>
#include <vector>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Decides which positions a map can hold (map/max_cells). Not thread-safe.
///
/// All positions that were accepted lie in a reserved extent, stray or not. It decides whether the
/// next position is accepted. If the position does not fit, the space of stray poses is released.
class MapExtent {
 public:
  using Extent = std::function<Box()>;

  /// @throw InputError if no map can hold its positions.
  MapExtent(const Config::Map& config, const std::vector<AccessPoint>& access_points);

  /// Of a map without readings [m], without margin.
  const Box& least() const { return least_; }

  /// Extends the reserved extent to a point, unless the map would be too large.
  /// @param of_inliers  the extent of all data that are not stray, if it is needed
  InsertResult makeRoomFor(const Position& point, const Extent& of_inliers);

  /// Extends the reserved extent to a point, and releases nothing.
  InsertResult reserve(const Position& point);

  /// Extends the reserved extent to everything that was moved.
  /// @return false, and changes nothing, if the map would be too large.
  bool reserveMoved(const Box& all);

  /// Gives the reserved extent anew: that of inliers if they fit a map, else the least one.
  void release(const Box& of_inliers);

  /// Makes all later maps cover a box, unless the map would be too large.
  void growTo(const Box& extent);

  /// Forgets the positions. Later maps cover their extent all the same.
  void restart(const Box& of_inliers);

  /// Makes room for the positions of another table.
  /// @throw as the constructor
  void extendTo(const std::vector<AccessPoint>& access_points);

  /// The grid of a map with an extent.
  /// @throw InputError if it would have more than map/max_cells cells.
  GridGeometry geometryOf(const Box& extent) const;

 private:
  bool fits(const Box& extent) const;

  Config::Map config_;
  Box least_;
  Box reserved_;
  bool holds_stray_room_ = false;  // false: the reserved extent is that of the inliers
};

}  // namespace sfw
