#pragma once

#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/types.h"

namespace sfw {

// Decides which cells are free, occupied or unknown: the last steps from probabilities to a map.

/// Enters the evidence of the robot's body: its footprint along the path becomes free, and the
/// cells of contacts become occupied.
/// @param path                cells that the robot's antenna crossed, on the map's grid
/// @param footprint_radius_m  of the robot
/// @param occupied            probabilities, changed in place
/// Linear in cells.
void stampFootprintAndContacts(const Mask& path, const std::vector<Contact>& contacts,
                               double footprint_radius_m, Grid<float>& occupied);

/// Labels each cell as free, occupied or unknown by moving its probability across the thresholds.
///
/// A cell is free if it is below belief/free_threshold and connected with the path over edges.
/// Islands in the free area without a clear obstacle are free too. Walls become occupied. The rim,
/// every cell next to a free one over an edge or a corner, takes the state that belief/rim names.
/// All other cells become unknown, because there is no evidence beyond the rim. Contacts and cells
/// without evidence keep their values.
/// @param path      cells that the robot's antenna crossed, on the map's grid
/// @param walls     cells of walls
/// @param occupied  probabilities, changed in place
/// Linear in cells.
void labelFreeAndRim(const Mask& path, const Mask& walls, const Config::Belief& config,
                     Grid<float>& occupied);

}  // namespace sfw
