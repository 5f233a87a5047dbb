#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "structure_from_wifi/belief_model.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/training_drive.h"

namespace sfw {

/// Cells of known state, of many drives of one kind.
struct TrainingCells {
  std::vector<std::array<float, kCellFeatures>> cells;
  std::vector<std::uint8_t> free;          ///< 1 if so, for each cell
  std::vector<BeliefModel::Style> styles;  ///< of each drive
};

/// Cells of one drive: about `count` of those that describeCells describes, chosen by the seed.
/// @throw as describeDrive
TrainingCells cellsOf(const TrainingDrive& drive, const Config& config, std::size_t count,
                      std::int64_t seed);

/// Fits one expert: logistic regression with a ridge of a hundred on standardised features, by
/// Newton's method, and the normal distribution of the styles. Deterministic. O(cells) for each
/// iteration.
/// @throw std::invalid_argument if there are no cells, or fewer than five drives.
BeliefModel::Expert fitExpert(const TrainingCells& cells);

}  // namespace sfw
