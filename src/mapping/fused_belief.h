#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "base/use_radio.h"
#include "belief/belief_model.h"
#include "belief/drive_features.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/wall_segment.h"
#include "walls/wall_network.h"

namespace sfw {

/// The belief model trusts walls within these limits of the explained variance. The lower one is a
/// little above the median of the training drives (.5). One in ten or twenty of these drives passes
/// the upper one. Signals with wrong positions explain too little, and then the model would doubt
/// the path too. Few readings of many walls explain too much.
constexpr ExplainedVarianceLimits kTrustedVariance{0.55, 0.7};

/// The result of tomography and the belief model, on the grid of a map. Both grids of occupancy
/// hold probabilities of being occupied.
struct FusedBelief {
  Grid<float> occupied;     ///< after the decision of cells; 0.5 exactly where nothing is known
  Grid<float> probability;  ///< before any decision; 0.5 exactly where nothing is known
  Grid<float> wall_loss;    ///< of signals through each cell, by radio alone [dB]
  StyleShares style{};      ///< share of the expert for each driving style
  double explained_variance = 0.0;  ///< as explainedVariance, without limits
  BuildingFrame frame;

  /// Loss by the estimated walls on the ray to each sample of each access point [dB].
  std::vector<std::vector<double>> sample_loss_db;

  std::vector<WallSegment> walls;  ///< that the network found, map frame
};

/// Infers the occupancy of all cells by line-field tomography and the belief model
/// (doc/method/belief.md).
///
/// Cells below belief/free_threshold are connected with the path. Cells above
/// belief/occupied_threshold are walls between two passes, contacts, or an occupied rim. All other
/// cells with evidence lie in between, because the data do not show whether a wall stands there.
/// @param geometry   of the map
/// @param network    finds walls beside the way of the robot; no such walls without it
/// @param use_radio  kNo: the ablation without signal strength
/// @param stop       polled; when it turns true the result is incomplete
/// @param kept       as of extractDriveFeatures
/// @throw as extractDriveFeatures
FusedBelief inferOccupancyByTomography(const GridGeometry& geometry, const DriveData& drive,
                                       const BeliefModel& model,
                                       const std::optional<WallNetwork>& network,
                                       const Config& config, UseRadio use_radio,
                                       const std::atomic<bool>& stop, KeptFeatures* kept = nullptr);

}  // namespace sfw
