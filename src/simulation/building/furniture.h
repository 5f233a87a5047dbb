#pragma once

#include <cstdint>
#include <vector>

#include "simulation/building/floor_plan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Something in a room that weakens signals and that no map shows: an upright cylinder. It does not
/// keep a robot from driving.
struct Furniture {
  Position centre = Position::Zero();  ///< [m]
  double radius_m = 0.0;
  double loss_db = 0.0;  ///< of each line through it
};

/// One piece for so much free space, in free cells chosen by the seed; radii of 0.2 to 0.5 m and
/// losses of 0 to `most_loss_db`, all equally likely.
/// @param area_per_piece_m2  finite and positive
std::vector<Furniture> placeFurniture(const FloorPlan& plan, double most_loss_db,
                                      double area_per_piece_m2, std::int64_t seed);

/// What all pieces on the line between two points take away [dB]. O(pieces).
double furnitureLoss(const std::vector<Furniture>& pieces, const Position& from,
                     const Position& to);

}  // namespace sfw
