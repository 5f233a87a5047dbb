#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "belief/belief_model.h"
#include "path/building_frame.h"
#include "radio/radio_bins.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// What one access point was heard with.
struct AccessPointSamples {
  Position access_point_in_map = Position::Zero();  ///< [m]
  std::optional<double> height_m;                   ///< of the access point above the floor
  std::vector<Sample> samples;                      ///< in the order heard
};

/// Everything that a map is inferred from.
struct DriveData {
  std::vector<Position> path;             ///< all positions [m] in the order driven, map frame
  std::vector<AccessPointSamples> heard;  ///< by each access point
  std::vector<Contact> contacts;          ///< obstacles touched: they stay occupied
};

/// The fields of a drive in the building frame, before any belief.
struct DriveFeatures {
  BuildingFrame frame;
  std::vector<AccessPointBins> heard;
  WallField walls;
  CellFeatures cells;
};

/// Solves for the walls and describes all cells.
/// @param drive  with at least one position
/// @param stop   polled; when it turns true the result is incomplete
/// @throw InputError if the grid would have more than four times map/max_cells.
DriveFeatures extractDriveFeatures(const DriveData& drive, const Config& config,
                                   const std::atomic<bool>& stop);

/// What tomography and the fused belief make of a drive, on the grid of a map.
struct FusedBelief {
  Grid<float> occupied;    ///< probability; 0.5 exactly where nothing is known
  Grid<float> wall_loss;   ///< of signals through each cell, by radio alone [dB]
  StyleShares style{};     ///< how far the model for each driving style was used
  double explained = 0.0;  ///< as explainedVariance
  BuildingFrame frame;

  /// Loss on the way to each sample of each access point, by the walls found [dB].
  std::vector<std::vector<double>> sample_loss;
};

/// Line-field tomography and the fused belief (doc/method/belief.md).
///
/// Probabilities below belief/free_threshold are of cells that hang together with the path; those
/// above belief/occupied_threshold are of cells at the rim of these, and of contacts. All others
/// that something is known of lie in between: free or not, nobody can say whether a wall is there.
/// @param geometry  of the map
/// @param radio     false: the control without signal strength
/// @param stop      as for extractDriveFeatures
FusedBelief inferOccupancyByTomography(const GridGeometry& geometry, const DriveData& drive,
                                       const BeliefModel& model, const Config& config, bool radio,
                                       const std::atomic<bool>& stop);

}  // namespace sfw
