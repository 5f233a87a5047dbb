#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "belief/feature_table.h"
#include "grid/mask.h"
#include "path/path_style.h"
#include "radio/radio_bins.h"
#include "tomography/wall_field.h"

namespace sfw {

/// Only cells within this distance of the path are described [m].
constexpr double kMaxDistanceToPath = 3.0;

/// Features of the cells near a path: the input of a belief model. They do not depend on which of
/// the building's axes is called x.
struct CellFeatures {
  GridGeometry geometry;              ///< building frame
  std::vector<std::size_t> cells;     ///< indices of those within kMaxDistanceToPath of the path
  std::vector<FeatureVector> values;  ///< of each of `cells`
  PathStyle style;
  double explained_variance = 0.0;  ///< as explainedVariance, without limits
};

/// A path in the building frame.
struct DrivenPath {
  Mask cells;                    ///< that it crosses; kMaxDistanceToPath away from the grid's edges
  std::vector<Position> driven;  ///< positions [m] in the order driven, not empty
  double max_gap_m = 1.0;        ///< successive positions farther apart are not joined
  double robot_radius_m = 0.15;
};

/// Limits of the explained variance that enters features. The default changes nothing.
struct ExplainedVarianceLimits {
  double least = 0.0;
  double most = 1.0;
};

/// Extracts the features of every cell near a path.
/// @param stop  polled; when it turns true the result is incomplete
/// O(cells log cells + cells crossed by rays).
CellFeatures extractCellFeatures(const DrivenPath& path,
                                 const std::vector<AccessPointBins>& access_points,
                                 const WallField& walls, const std::atomic<bool>& stop,
                                 const ExplainedVarianceLimits& limits = {});

}  // namespace sfw
