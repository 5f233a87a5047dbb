#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "radio/signal_covariance.h"
#include "structure_from_wifi/types.h"
#include "tomography/wall_field.h"

namespace sfw {

/// Settings of the cross-validation.
struct PredictionConfig {
  PredictionConfig();

  double stretch_m = 3.0;        ///< length of a hidden stretch of the path
  int folds = 5;                 ///< each hides every fifth stretch
  double bin_size_m = 0.2;       ///< edge of the squares whose mean signals are predicted
  double robot_radius_m = 0.15;  ///< no wall stands closer to the path
  WallFieldConfig walls;
  SignalCovariance shadowing;  ///< of the residual that neither distance nor walls explain
};

/// Root-mean-square errors of predicted signals, over all hidden bins of all access points.
struct PredictionMetrics {
  std::size_t bins = 0;               ///< number of hidden bins
  double distance_db = 0.0;           ///< predicted by the law of distance alone
  double walls_db = 0.0;              ///< by distance and the walls found from the other stretches
  double distance_shadowed_db = 0.0;  ///< by distance and the signals of the nearest bins
  double walls_shadowed_db = 0.0;     ///< by all three
  double kriging_db = 0.0;            ///< by ordinary kriging, which knows no access point
  double mrpt_db = 0.0;               ///< by MRPT's grid with the best of four kernels, likewise
};

/// Measures how well distance and walls predict hidden signals. It needs no true map.
///
/// The path is cut into stretches, which are assigned to folds in turn. Each fold is hidden once,
/// for all access points. The other readings give the walls, and power and exponent with the priors
/// of `shadowing`. From these, the mean signals of the hidden bins are predicted. Predictions are
/// made with and without the walls' losses, and with and without the signals of the nearest bins.
/// The latter come from a Gaussian process about the law of distance, whose shadowing is fitted to
/// each access point (learnSignalLaw). The gain of walls over distance measures the radio's
/// information about the building. The nearest bins alone reach much of that gain.
///
/// @param readings       map frame, in any order
/// @param access_points access points without readings are skipped
/// @param stop           polled; when it turns true there is no result
/// @return nothing if no hidden bin can be predicted, or if the extent of the readings needs more
/// than 16 million cells.
/// Deterministic. Cost: folds times that of estimateWalls, plus O(bins) small systems of equations.
std::optional<PredictionMetrics> predictHiddenStretches(
    const std::vector<Reading>& readings, const std::vector<AccessPoint>& access_points,
    const PredictionConfig& config, const std::atomic<bool>& stop);

}  // namespace sfw
