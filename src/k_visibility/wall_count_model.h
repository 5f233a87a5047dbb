#pragma once

#include <cstddef>
#include <vector>

namespace sfw {

/// Counts walls from signal strength alone: K-means with K + 1 centroids (Fafoutis et al. 2015;
/// doc/method/k_visibility.md). Immutable.
class WallCountModel {
 public:
  /// The least-squares clustering of `rssi_dbm` (finite, in (-120, 0]) into `walls` + 1 groups.
  ///
  /// Exact and independent of order: in one dimension groups are intervals, and dynamic
  /// programming over a histogram of 0.1 dB finds the best cut. Fewer distinct values than
  /// groups give fewer walls. The model of an empty input counts 0 walls for every signal.
  static WallCountModel fit(const std::vector<double>& rssi_dbm, std::size_t walls);

  /// Fits as fit() does, with the K in 1..`max_walls` of the highest mean silhouette (Rousseeuw
  /// 1987, with distances to group means). Only models whose neighbouring centroids are at least
  /// `min_wall_loss_db` apart count, since closer groups are noise cut in two. K is 0 if there is
  /// no such model.
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
