#pragma once

#include <string>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Reads a map as map_server writes it: YAML beside a PGM (P2 or P5, 8 bit).
///
/// Pixels become states by the file's own negate, occupied_thresh and free_thresh.
/// @throw InputError naming the file if it cannot be read, is cut short, is rotated (yaw other
/// than 0), is of another image type or mode (`raw`), or holds a value that makes no sense.
Grid<CellState> readMap(const std::string& yaml_file);

/// As readMap, but each pixel's probability of being occupied in [0, 1].
Grid<float> readProbabilities(const std::string& yaml_file);

/// Reads losses of signals [dB] as the mapper writes them (wallLossYaml): a pixel's value times the
/// file's `decibels_per_step`.
/// @throw InputError as readMap, and if that key is missing or not a positive number
Grid<float> readWallLoss(const std::string& yaml_file);

}  // namespace sfw
