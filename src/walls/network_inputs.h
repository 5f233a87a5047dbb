#pragma once

#include <string>
#include <vector>

#include "base/use_radio.h"
#include "belief/belief_model.h"
#include "belief/drive_features.h"
#include "walls/row_source.h"

namespace sfw {

/// Edge of the cells that a network of walls sees [m].
constexpr double kNetworkCellM = 0.1;

/// Log odds of a probability, limited to 1 : 999, as the network sees them.
float limitedLogOdds(float probability);

/// The cells that the robot covered, on the grid of the path.
Mask footprintOf(const DrivenPath& path);

/// Makes the rasters that a network of walls sees: one channel for each row of its table of inputs.
/// The mapper and the network's training both call this function, so both see the same.
///
/// The rasters are 0 in cells that are not described. Without radio, all rasters that depend on
/// signal strength are 0, as in the network's training.
/// @param features   on cells of kNetworkCellM
/// @param footprint  as of footprintOf
/// @param style      share of the belief model for each driving style
/// @param free       probability of free space, with the same radio, as of freeProbability
/// @return rows of rasters; `features`, `footprint` and `free` must outlive them
RowSource networkInputs(const DriveFeatures& features, const Mask& footprint,
                        const BeliefModel& model, const StyleShares& style, UseRadio use_radio,
                        const Grid<float>& free);

/// Names of the channels of networkInputs, in order.
std::vector<std::string> networkInputNames();

/// Names of the channels of networkInputs that are 0 without radio.
std::vector<std::string> networkRadioInputNames();

}  // namespace sfw
