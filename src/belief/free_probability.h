#pragma once

#include <cstddef>
#include <vector>

#include "base/use_radio.h"
#include "belief/belief_model.h"
#include "belief/cell_features.h"

namespace sfw {

/// Draws the log odds of described cells towards the mean along one axis of the building.
///
/// The row and the column each have a mean over 0.6 m to both sides. The lower mean counts. Walls
/// are straight. So low log odds of a line of cells stay low, and low log odds of a single cell
/// rise.
/// @param cells     indices of the described cells; no other cell counts or changes
/// @param log_odds  of free space, 0 in all other cells; changed in place
/// Linear in cells.
void straighten(const std::vector<std::size_t>& cells, Grid<float>& log_odds);

/// Probability that cells of the building frame are free; 0.5 where cells are not described.
///
/// The model gives the probability of each cell by itself. Then the log odds are straightened, and
/// the probabilities are blurred by 0.1 m.
/// @param style      share of the model for each driving style
/// @param use_radio  kNo: by the features of the path alone, the ablation `no radio`
/// Linear in cells.
Grid<float> freeProbability(const CellFeatures& described, const BeliefModel& model,
                            const StyleShares& style, UseRadio use_radio);

}  // namespace sfw
