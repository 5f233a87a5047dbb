#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "radio/nearest_neighbours.h"
#include "radio/signal_covariance.h"
#include "radio/vecchia_rows.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Predicts signals from the nearest eight bins, for four positions at once.
class LocalKriging {
 public:
  static constexpr int kNeighbours = 8;

  /// @param positions  of the bins [m]; must outlive this
  /// @param noise_db2  variance of each bin's mean; must outlive this
  LocalKriging(const std::vector<Position>& positions, const std::vector<double>& noise_db2,
               const SignalCovariance& covariance);

  /// Sets the position that a lane predicts.
  /// @param own_db2   variance that no bin shares
  /// @param left_out  a bin that is not used, or -1
  void set(int lane, const Position& position, double own_db2, int left_out = -1);

  void solve() { rows_.solve(covariance_); }

  /// Standard deviation of the prediction [dB].
  double deviation(int lane) const { return 1.0 / rows_.scale(lane); }

  /// Number and weight of a lane's neighbour in 0..7; a missing one has weight 0.
  int bin(int lane, int neighbour) const {
    return bins_[static_cast<std::size_t>(lane)][static_cast<std::size_t>(neighbour)];
  }
  double weight(int lane, int neighbour) const { return rows_.weight(lane, neighbour); }

 private:
  const std::vector<Position>& positions_;
  const std::vector<double>& noise_db2_;
  SignalCovariance covariance_;
  NearestNeighbours nearest_;
  VecchiaRows<kNeighbours> rows_;
  std::array<std::array<int, kNeighbours>, kLanes> bins_{};
};

}  // namespace sfw
