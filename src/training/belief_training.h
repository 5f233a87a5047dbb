#pragma once

#include <cstdint>
#include <vector>

#include "belief/belief_model.h"
#include "structure_from_wifi/config.h"
#include "training/training_drive.h"

namespace sfw {

/// Labelled cells of one drive.
struct TrainingCells {
  DrivingStyle made = DrivingStyle::kAlongWalls;  ///< style in which the drive was simulated
  PathStyle style;                                ///< style as measured on the path
  std::vector<FeatureVector> cells;
  std::vector<std::uint8_t> free;  ///< for each cell: 1 if it is free, else 0
};

/// Draws about `count` of the described cells of a drive at random.
/// @throw as extractDriveFeatures
TrainingCells drawTrainingCells(const TrainingDrive& drive, const Config& config, std::size_t count,
                                std::int64_t seed);

/// Fits a belief model to labelled cells.
///
/// The distribution of each style is fitted to the drives simulated in it. Each expert is then
/// fitted to all drives, weighted by its share in them. A stretch along walls may look like a
/// patrol, so the expert of patrols must be fitted to such stretches too. The fit is a logistic
/// regression with a ridge of 100 on standardised features, by Newton's method. Deterministic.
/// O(cells) for each iteration.
/// @throw std::invalid_argument if a style has fewer than five drives, or cells and their states
///        differ in number.
BeliefModel fitBeliefModel(const std::vector<TrainingCells>& drives);

}  // namespace sfw
