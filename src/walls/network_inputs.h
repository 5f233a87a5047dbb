#pragma once

#include <string>
#include <vector>

#include "base/use_radio.h"
#include "belief/drive_features.h"
#include "walls/channels.h"

namespace sfw {

/// Probabilities of free space by the belief model, in the building frame; 0.5 where cells are not
/// described.
struct ModelProbabilities {
  Grid<float> single;        ///< of each cell by itself
  Grid<float> straightened;  ///< as freeProbability returns them
};

/// Edge of the cells that a network of walls sees [m].
constexpr double kNetworkCellM = 0.1;

/// Log odds of a probability, limited to 1 : 999, as the network sees them.
float limitedLogOdds(float probability);

/// Makes the rasters that a network of walls sees: one channel for each row of its table of inputs.
///
/// The rasters are 0 in cells that are not described. Without radio, all rasters that depend on
/// signal strength are 0, as in the network's training.
/// @param features       on cells of kNetworkCellM
/// @param footprint      cells that the robot covered
/// @param with_radio,without_radio  probabilities of the belief model
Channels networkInputs(const DriveFeatures& features, const Mask& footprint,
                       const ModelProbabilities& with_radio,
                       const ModelProbabilities& without_radio, UseRadio use_radio);

/// Names of the channels of networkInputs, in order.
std::vector<std::string> networkInputNames();

}  // namespace sfw
