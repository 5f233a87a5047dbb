#pragma once

#include <cstddef>
#include <vector>

namespace sfw {

/// Median or mean over the window of `window` neighbours centred on each value.
///
/// At the ends the window shrinks symmetrically, so a linear trend is kept.
/// @param window odd, at least 1 (1 returns the input)
std::vector<double> slidingMedian(const std::vector<double>& values, std::size_t window);
std::vector<double> slidingMean(const std::vector<double>& values, std::size_t window);

/// Signal strength as it would be at 1 m if distance alone had weakened it: what is left differs
/// by the walls on the way.
///
/// @param exponent of the path loss: 10 exponent log10(distance) dB are given back. With line of
/// sight indoors 0.7 to 1.7 are measured (doc/method/k_visibility.md).
/// @param distance_m distances below 0.3 m count as 0.3 m, where the far-field law ends
double withoutPathLoss(double rssi_dbm, double distance_m, double exponent);

/// Wall counts from signal strength alone: K-means with K + 1 centroids (Fafoutis et al. 2015;
/// doc/method/k_visibility.md). Immutable.
class WallCountModel {
 public:
  /// The least-squares clustering of `rssi_dbm` (finite, in (-120, 0]) into `walls` + 1 groups.
  ///
  /// Exact and independent of order: in one dimension groups are intervals, and dynamic
  /// programming over a histogram of 0.1 dB finds the best cut. Fewer distinct values than
  /// groups give fewer walls. An empty input gives a model that always answers 0.
  static WallCountModel fit(const std::vector<double>& rssi_dbm, std::size_t walls);

  /// As fit() with the K in 1..`max_walls` of the highest mean silhouette (Rousseeuw 1987, with
  /// distances to group means) among those whose neighbouring centroids all stay at least
  /// `min_wall_loss_db` apart; 0 if there is none: closer groups are no walls but noise cut in two.
  static WallCountModel choose(const std::vector<double>& rssi_dbm, std::size_t max_walls,
                               double min_wall_loss_db);

  /// Walls between transmitter and receiver, 0..walls().
  int count(double rssi_dbm) const;

  /// Largest count K.
  std::size_t walls() const { return thresholds_dbm_.size(); }

  /// C_0 > ... > C_K [dBm]; empty if fitted to nothing.
  const std::vector<double>& centroids() const { return centroids_dbm_; }

  /// t_1 > ... > t_K [dBm], the means of neighbouring centroids.
  const std::vector<double>& thresholds() const { return thresholds_dbm_; }

 private:
  explicit WallCountModel(std::vector<double> centroids_dbm);

  std::vector<double> centroids_dbm_;
  std::vector<double> thresholds_dbm_;
};

}  // namespace sfw
