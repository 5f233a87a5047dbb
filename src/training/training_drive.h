#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/random.h"
#include "path/path_style.h"
#include "simulation/building/floor_plan.h"
#include "simulation/radio/radio_model.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A simulated drive for training, with the labels that a lidar would give.
struct TrainingDrive {
  std::vector<Reading> readings;
  std::vector<AccessPoint> access_points;
  DrivingStyle style = DrivingStyle::kAlongWalls;
  Grid<CellState> truth;     ///< labels, as of visibleStates
  Grid<CellState> building;  ///< the state of each cell, seen or not, with furniture
};

/// What varies between training drives besides the building and the style.
struct TrainingDriveSettings {
  ScenarioConfig scenario;  ///< its route follows from the style
  bool plain = false;       ///< as `sfw simulate` drives: no furniture, no cuts, the whole building
  bool varies_radio = true;  ///< false: the radio of the noise level as it is
};

/// Simulates a drive through a building, as varied as real drives (doc/method/belief.md).
///
/// - up to three rectangles are cut out of the building, as if they were inaccessible;
/// - along walls and on patrols, furniture often blocks the robot, but not the radio;
/// - the robot has a radius of 1 to 15 cm, because small robots come that close to the walls of a
///   lidar's map. It follows walls tightly or loosely and cuts corners, or it patrols, or it
///   strolls: it roams around on the way, up to the walls. It covers all or a part of the building;
/// - the radio is mostly `realistic`, with walls of 2 to 11 dB, and 1 to 16 access points;
/// - receivers, positions and signals have the errors of disturb().
///
/// @return nothing if the robot fits nowhere in the rest of the building.
/// Deterministic.
std::optional<TrainingDrive> makeTrainingDrive(const FloorPlan& plan, DrivingStyle style,
                                               std::int64_t seed);

/// Simulates a drive with given settings. The rest varies as in makeTrainingDrive.
/// @return nothing if the robot fits nowhere in the rest of the building.
std::optional<TrainingDrive> simulateTrainingDrive(const FloorPlan& plan, DrivingStyle style,
                                                   const TrainingDriveSettings& settings,
                                                   Random& random);

constexpr double kMostAccessPoints = 16.0;  ///< of a drive

/// Draws a noise level from all of them; `realistic` is the most frequent one.
NoiseLevel chooseNoise(Random& random);

/// Draws a whole number from 1 to `most`, with about equal chances in each octave.
std::int64_t chooseCount(double most, Random& random);

/// Draws the losses of walls, their limit and the shadowing from ranges wider than those of the
/// noise levels. A radio without much shadowing keeps its own.
void varyRadio(RadioModel::Config& radio, Random& random);

/// Positions [m] of the readings, without repetitions in a row.
std::vector<Position> pathOf(const std::vector<Reading>& readings);

/// Labels the cells that a lidar sees from a path. Free cells in sight stay free, occupied cells
/// within two cells of them stay occupied, and all others become unknown.
/// @param path    positions [m], in the frame of `states`
/// @param states  the true state of each cell
Grid<CellState> visibleStates(const std::vector<Position>& path, const Grid<CellState>& states);

}  // namespace sfw
