#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "radio/signal_covariance.h"
#include "structure_from_wifi/types.h"
#include "tomography/wall_field.h"

namespace sfw {

/// How readings are hidden and predicted.
struct PredictionConfig {
  PredictionConfig();

  double stretch = 3.0;        ///< way that is hidden at a time [m]
  int folds = 5;               ///< each hides every fifth stretch
  double bin = 0.2;            ///< edge of the squares whose mean signals are predicted [m]
  double robot_radius = 0.15;  ///< no wall stands closer to the path [m]
  WallFieldConfig walls;
  SignalCovariance shadowing;  ///< of what neither distance nor walls explain
};

/// How far predictions are from the signals on hidden stretches: root mean squares over all bins of
/// all access points [dB].
struct PredictionMetrics {
  std::size_t bins = 0;            ///< hidden ones
  double distance = 0.0;           ///< predicted by the law of distance alone
  double walls = 0.0;              ///< and the walls that the other stretches tell of
  double distance_shadowed = 0.0;  ///< by distance and the signals of the nearest places
  double walls_shadowed = 0.0;     ///< by all three
};

/// Says how much of the signals is understood, which needs no truth but the recording itself.
///
/// The way is cut into stretches, dealt to folds in turn. Each fold is hidden once, for all access
/// points: from the other readings walls are estimated, power and exponent fitted with the priors
/// of `shadowing`, and the mean signals of the hidden bins predicted, with and without the walls'
/// losses and the residuals of the nearest 16 bins (kriging). What walls gain over distance is
/// what radio knows about the building; nearest places alone gain much of it without knowing why.
///
/// @param readings       map frame, in any order
/// @param access_points  those that have no readings are left out
/// @param stop           polled; when it turns true there is no result
/// @return nothing if no bin was hidden that could be predicted, or the readings reach too far for
/// a grid of 16 million cells.
/// Deterministic. Cost: folds times that of estimateWalls, plus O(bins) small systems of equations.
std::optional<PredictionMetrics> predictHiddenStretches(
    const std::vector<Reading>& readings, const std::vector<AccessPoint>& access_points,
    const PredictionConfig& config, const std::atomic<bool>& stop);

}  // namespace sfw
