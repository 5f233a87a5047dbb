#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "belief/belief_model.h"
#include "structure_from_wifi/config.h"
#include "training/training_drive.h"

namespace sfw {

/// Cells of known state, of one drive.
struct TrainingCells {
  DrivingStyle made = DrivingStyle::kAlongWalls;  ///< the style that the drive was made in
  PathStyle style;                                ///< what it looks like
  std::vector<std::array<float, kCellFeatures>> cells;
  std::vector<std::uint8_t> free;  ///< 1 if so, for each cell
};

/// Cells of a drive: about `count` of those that extractCellFeatures describes, chosen by the seed.
/// @throw as extractDriveFeatures
TrainingCells cellsOf(const TrainingDrive& drive, const Config& config, std::size_t count,
                      std::int64_t seed);

/// Fits the distribution of each style to the drives made in it, and each expert to all drives by
/// the share that it then has in them: a stretch along walls may look like a patrol, and the expert
/// of patrols has to reckon with it. Logistic regression with a ridge of a hundred on standardised
/// features, by Newton's method. Deterministic. O(cells) for each iteration.
/// @throw std::invalid_argument if a style has fewer than five drives, or cells and their states
///        differ in number.
BeliefModel fitBeliefModel(const std::vector<TrainingCells>& drives);

}  // namespace sfw
