#pragma once

#include <string>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Reads a map as map_server does: YAML beside an image, as readImage reads it. Transparent pixels
/// are unknown.
///
/// The keys mode, negate, occupied_thresh and free_thresh of the file turn pixels into states. In
/// mode trinary, the grey 205 is unknown for any free_thresh, if lighter pixels are free: Nav2 and
/// slam_toolbox write 0.25 beside such maps. A yaw of the origin turns the map, as `turned` does.
/// @throw InputError naming the file if it cannot be read, is cut short, has an unknown image type
/// or mode, or contains an invalid value, such as a yaw that is no number.
Grid<CellState> readMap(const std::string& yaml_file);

/// Reads the probability of being occupied of each pixel, in [0, 1]; 0.5 where it is transparent.
/// @throw InputError as readMap
Grid<float> readProbabilities(const std::string& yaml_file);

/// Reads losses of signals [dB] as wallLossPgm and wallLossYaml write them: a pixel's value times
/// the file's `decibels_per_step`.
/// @throw InputError as readMap, and if that key is missing or not a positive number
Grid<float> readWallLoss(const std::string& yaml_file);

/// The grey value that map_server reads as a state: 254 free, 0 occupied, 205 unknown.
int pixelOf(CellState state);

/// The YAML beside an image of states.
std::string trinaryYaml(const GridGeometry& geometry, const std::string& image = "map.pgm");

/// The YAML beside probability.png, whose pixels are 255 (1 - p), or transparent where p is
/// unknown.
std::string probabilityYaml(const GridGeometry& geometry);

/// The YAML beside costs.png, whose pixels are 255 (1 - cost / 100), or transparent where the cost
/// is unknown.
std::string costsYaml(const GridGeometry& geometry);

constexpr double kWallLossStepDb = 0.05;  ///< of a grey value in wall_loss.pgm

/// The image of losses of signals [dB]: each grey value is kWallLossStepDb, from 0 (black) to 255.
std::string wallLossPgm(const Grid<float>& wall_loss_db);

/// The YAML beside wall_loss.pgm: mode scale, negated.
std::string wallLossYaml(const GridGeometry& geometry);

/// Writes NAME.pgm and NAME.yaml of states. Makes the directory.
/// @throw std::system_error naming the file and why
void writeMap(const Grid<CellState>& states, const std::string& directory, const std::string& name);

}  // namespace sfw
