#pragma once

#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Distances from each cell of a building to the nearest cell that is not free.
class Clearance {
 public:
  /// @param least_m  what allows() asks for [m]
  Clearance(const FloorPlan& plan, double least_m);

  /// The distance at a cell [m]; 0 outside the building.
  double at(Cell c) const {
    return distance_.geometry.contains(c) ? distance_[c] * distance_.geometry.resolution() : 0.0;
  }

  /// Returns whether a straight line keeps the least clearance. Points are in the map frame [m].
  /// O(length).
  bool allows(const Position& from, const Position& to) const;

 private:
  Grid<double> distance_;
  double least_m_;
};

}  // namespace sfw
