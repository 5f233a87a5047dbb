#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "base/use_radio.h"
#include "belief/drive_features.h"
#include "mapping/inliers.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// The map that a method infers.
struct MethodResult {
  Grid<float> occupied;     ///< probability, after decisions; 0.5 exactly where nothing is known
  Grid<float> probability;  ///< the same before decisions

  /// Walls between each access point and each of its samples; empty for an access point without
  /// position.
  std::vector<std::vector<int>> walls = {};

  std::vector<WallCountClusters> wall_counts = {};   ///< of each access point, k_visibility only
  std::optional<TomographySummary> tomography = {};  ///< tomography only
  std::vector<WallSegment> wall_segments = {};       ///< between passes of the robot
};

/// A way to infer a map from the inliers of a drive. Immutable, so that threads may share one.
class MapMethod {
 public:
  virtual ~MapMethod() = default;

  /// Infers a map on a grid.
  /// @param inliers        the method may take the samples while it infers, and gives them back
  /// @param access_points  in the order of `inliers.readings`; the method ignores the readings of
  ///                       those without position
  /// @param stop           polled; once it is true, the result is incomplete
  /// @param kept           by a live map from one refresh to the next; nullptr: nothing is
  virtual MethodResult infer(const GridGeometry& geometry, Inliers& inliers,
                             const std::vector<AccessPointSummary>& access_points,
                             UseRadio use_radio, const std::atomic<bool>& stop,
                             KeptFeatures* kept) const = 0;
};

std::unique_ptr<const MapMethod> makeTomographyMethod(const Config& config);
std::unique_ptr<const MapMethod> makeKVisibilityMethod(const Config& config);

}  // namespace sfw
