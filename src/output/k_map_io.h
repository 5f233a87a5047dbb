#pragma once

#include <cstdint>
#include <string>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The wall count of every cell, and its access point.
struct KMap {
  Grid<std::uint8_t> counts;                 ///< values as in k_visibility.h
  Position access_point = Position::Zero();  ///< [m], map frame
};

/// Reads a k map: k.pgm with k.yaml (image, resolution, origin, access_point) beside it.
/// @param file either of the two
/// @throw InputError naming the file and its problem.
KMap readKMap(const std::string& file);

/// Writes k.pgm, k.yaml and k.png, the picture in the colours of wallCountColour, into a directory
/// that is made if missing. Each file appears complete or not at all.
/// @throw std::system_error naming the file and why.
void writeKMap(const KMap& k_map, const std::string& directory);

}  // namespace sfw
