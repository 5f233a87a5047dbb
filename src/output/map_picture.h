#pragma once

#include <string>

#include "files/colour.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// The colour of a wall count, as in the paper's figures: red 0, green 1, blue 2, yellow 3, then
/// a fixed scale; grey for PathPose::kNoWallCount.
Colour wallCountColour(int walls);

/// A PNG for people: the known part of the map, the path coloured by wall count with its legend,
/// the access points with their names, and a scale bar.
/// @throw std::runtime_error if Cairo fails.
std::string renderPicture(const Snapshot& snapshot);

/// The same of states alone: free space, walls and one access point.
/// @throw std::runtime_error if Cairo fails.
std::string renderPicture(const Grid<CellState>& states, const Position& access_point);

}  // namespace sfw
