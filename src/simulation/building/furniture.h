#pragma once

#include <cstdint>
#include <vector>

#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A piece of furniture: an upright cylinder that attenuates signals. It does not block the robot
/// and no map shows it.
struct Furniture {
  Position centre = Position::Zero();  ///< [m]
  double radius_m = 0.0;
  double loss_db = 0.0;  ///< of each line through the piece
};

/// Places furniture in free cells: one piece for each `area_per_piece_m2` of free space.
///
/// The seed draws the cells, radii of 0.2 to 0.5 m and losses of 0 to `max_loss_db` uniformly.
/// @param area_per_piece_m2  finite and positive
std::vector<Furniture> placeFurniture(const FloorPlan& plan, double max_loss_db,
                                      double area_per_piece_m2, std::int64_t seed);

/// The total loss [dB] of all pieces on the line between two points. O(pieces).
double furnitureLoss(const std::vector<Furniture>& pieces, const Position& from,
                     const Position& to);

}  // namespace sfw
