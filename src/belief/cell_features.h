#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

#include "path/path_style.h"
#include "radio/radio_bins.h"
#include "tomography/wall_field.h"

namespace sfw {

constexpr std::size_t kCellFeatures = 38;

/// Names of the features in the order of a model file (doc/method/belief.md explains them).
const std::array<const char*, kCellFeatures>& cellFeatureNames();

/// Whether a feature depends on signal strength; all others are geometry of path and rays.
bool usesRadio(std::size_t feature);

/// Farthest from the path that a cell is judged [m].
constexpr double kMaxDistanceToPath = 3.0;

/// What the path, the rays and the radio say of single cells: the input of a belief model. Values
/// are of order one; none depends on which way round the building's axes lie.
struct CellFeatures {
  GridGeometry geometry;           ///< building frame
  std::vector<std::size_t> cells;  ///< indices of those within kMaxDistanceToPath of the path
  std::vector<std::array<float, kCellFeatures>> values;  ///< of each of `cells`
  PathStyle style;
  double explained = 0.0;  ///< as explainedVariance
};

/// A path in the building frame.
struct DrivenPath {
  Mask cells;                    ///< that it crosses; kMaxDistanceToPath away from the grid's edges
  std::vector<Position> driven;  ///< positions [m] in the order driven, not empty
  double max_gap_m = 1.0;        ///< successive positions farther apart are not joined
  double robot_radius_m = 0.15;
};

/// Describes every cell near a path.
/// @param stop  polled; when it turns true the result is incomplete
/// O(cells log cells + cells crossed by rays).
CellFeatures extractCellFeatures(const DrivenPath& path, const std::vector<AccessPointBins>& heard,
                                 const WallField& walls, const std::atomic<bool>& stop);

/// Cuts the share that walls explain, and the features that it weighs.
void clampExplainedVariance(double least, double most, CellFeatures& features);

}  // namespace sfw
