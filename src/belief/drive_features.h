#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "belief/cell_features.h"
#include "path/building_frame.h"
#include "radio/radio_bins.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/types.h"
#include "tomography/kept_members.h"

namespace sfw {

/// All readings of one access point.
struct AccessPointSamples {
  Position access_point_in_map = Position::Zero();  ///< [m]
  std::optional<double> height_m;                   ///< of the access point above the floor
  std::vector<Sample> samples;                      ///< in the order of their stamps

  /// Covariance of the access point's position [m2], map frame; zero if it is known.
  Eigen::Matrix2d covariance_in_map = Eigen::Matrix2d::Zero();
};

/// The data of a drive, from which a map is inferred.
struct DriveData {
  std::vector<Position> path;  ///< all positions [m] in the order driven, map frame
  std::vector<AccessPointSamples> access_points;
  std::vector<Contact> contacts;  ///< obstacles touched: their cells stay occupied
};

/// The inputs of the belief model in the building frame.
struct DriveFeatures {
  BuildingFrame frame;
  std::vector<AccessPointBins> access_points;
  WallField walls;
  CellFeatures cells;
  DrivenPath path;
};

/// What a live map keeps from one refresh to the next.
struct KeptFeatures {
  KeptMembers walls;
};

/// Estimates the walls from the signals of a drive and extracts the features of all cells.
/// @param drive   with at least one position
/// @param stop    polled; when it turns true the result is incomplete
/// @param limits  of the explained variance in the features
/// @param kept    of the refresh before, and changed; nullptr: everything is calculated anew
/// @throw InputError if the grid would have more than four times map/max_cells.
DriveFeatures extractDriveFeatures(const DriveData& drive, const Config& config,
                                   const std::atomic<bool>& stop,
                                   const ExplainedVarianceLimits& limits = {},
                                   KeptFeatures* kept = nullptr);

/// The cells that a path crosses, without those between positions farther apart than `max_gap_m`.
/// @param driven  positions [m] in the order driven, in the frame of `geometry`
Mask cellsCrossed(const GridGeometry& geometry, const std::vector<Position>& driven,
                  double max_gap_m);

}  // namespace sfw
