#pragma once

#include <string>

#include "files/colour.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// The colour of a wall count, as in the paper's figures: red 0, green 1, blue 2, yellow 3, then
/// a fixed scale; grey for PathPose::kNoWallCount.
Colour wallCountColour(int walls);

/// Draws the known part of a map as a PNG: cells, walls between passes of the robot, path coloured
/// by wall count, access points with names, coordinates, legend and scale bar.
///
/// The surer a wall, the darker its line. The loss of signals by walls shades free and unknown
/// cells.
/// @throw std::runtime_error if Cairo fails.
std::string renderPicture(const Snapshot& snapshot);

/// Draws the loss of signals by walls as a PNG, with path, access points, coordinates and scale.
/// @throw std::runtime_error if Cairo fails.
std::string renderWallLoss(const Grid<float>& wall_loss_db, const Snapshot& snapshot);

/// Draws states as a PNG: free space, walls and one access point.
/// @throw std::runtime_error if Cairo fails.
std::string renderPicture(const Grid<CellState>& states, const Position& access_point);

}  // namespace sfw
