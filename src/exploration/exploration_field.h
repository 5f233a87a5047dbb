#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/exploration.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// The rasters that an explorer plans on, made of a view. Not thread-safe.
///
/// Cells have 0.1 m. The grid reaches 4 m beyond the map, since the robot may go there.
class ExplorationField {
 public:
  /// @throw std::invalid_argument if the robot is so far from the map that no grid covers both
  ExplorationField(const ExplorationView& view, const Position& robot,
                   const ExplorationConfig& config);

  const GridGeometry& geometry() const { return obstacle_.geometry; }

  /// Probability that a cell holds something that stops the robot.
  const Grid<float>& obstacle() const { return obstacle_; }

  /// Whether the robot's centre cannot be in a cell: something that it touched is in the way.
  bool blocked(Cell c) const { return blocked_[c] != 0; }

  /// Rate of touches of a robot whose centre moves through a cell [1/m].
  float hazard(Cell c) const { return hazard_[c]; }

  /// Whether the robot's centre was there.
  bool driven(Cell c) const { return driven_[c] != 0; }

  /// Distance of a cell from the way of the robot [m].
  double distanceToWay(Cell c) const { return to_way_[c] * geometry().resolution(); }

  /// Free area that a robot at a cell would see and that neither map nor way know [m2]. O(view).
  double newArea(Cell c) const;

 private:
  void addMap(const ExplorationView& view);
  void addWalls(const std::vector<WallSegment>& walls);
  void addTouches(const std::vector<Touch>& touches);
  void joinTouches(const Touch& a, const Touch& b);
  void clearDriven(double radius_m);
  void findHazards(double radius_m);
  void block(const std::vector<Touch>& touches, const Position& robot, double radius_m);
  void findInterest(const ExplorationView& view);
  void findSight(double view_m);

  template <class Visitor>
  void forEachPair(const GridGeometry& map, Visitor&& visit) const;

  /// Calls `visit(Cell)` once for each cell seen from a cell: no obstacle lies in between.
  template <class Visitor>
  void forEachSeen(Cell from, Visitor&& visit) const;

  Grid<float> obstacle_;
  Grid<float> hazard_;
  Grid<float> interest_;  // probability that a cell is free and not known to be
  Mask blocked_;
  Mask driven_;
  Grid<double> to_way_;

  /// A cell around the robot, and the cell before it on the line of sight.
  struct Sight {
    Cell offset;
    std::size_t before;
  };
  std::vector<Sight> sight_;                // by distance
  mutable std::vector<std::uint8_t> open_;  // of forEachSeen, to allocate no memory
};

}  // namespace sfw
