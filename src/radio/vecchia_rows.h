#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "radio/signal_covariance.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Numbers of several positions side by side. The processor calculates with all of them at once.
constexpr int kLanes = 4;
using Lanes = Eigen::Array<double, kLanes, 1>;

/// Predicts the signal at one position from those at its neighbours, for four positions at once.
///
/// This gives rows of the factor in Vecchia's approximation (1988): the neighbours' weights in the
/// conditional mean and the conditional variance, by a small Cholesky factorisation for each row.
template <int kNeighbours>
class VecchiaRows {
 public:
  /// Inserts a position.
  /// @param lane     of the row
  /// @param index    0 for the row's own position, then the neighbours from 1 on
  /// @param own_db2  variance that no other position shares
  void put(int lane, int index, const Position& position, double own_db2) {
    const auto i = static_cast<std::size_t>(index);
    x_[i][lane] = position.x();
    y_[i][lane] = position.y();
    own_[i][lane] = own_db2;
    known_[i][lane] = 1.0;
  }

  /// Leaves the slot of a missing neighbour empty; its weight becomes 0.
  void putNone(int lane, int index) {
    put(lane, index, Position::Zero(), 1.0);
    known_[static_cast<std::size_t>(index)][lane] = 0.0;
  }

  /// Calculates all rows. O(neighbours^3).
  void solve(const SignalCovariance& model);

  /// One over the conditional standard deviation [1/dB].
  double scale(int lane) const { return scale_[lane]; }

  /// Weight of a neighbour in the conditional mean; neighbours count from 0.
  double weight(int lane, int neighbour) const {
    return weight_[static_cast<std::size_t>(neighbour)][lane];
  }

 private:
  std::array<Lanes, kNeighbours + 1> x_, y_, own_, known_;
  std::array<std::array<Lanes, kNeighbours>, kNeighbours> factor_;
  std::array<Lanes, kNeighbours> inverse_pivot_, weight_;
  Lanes scale_;
};

template <int kNeighbours>
void VecchiaRows<kNeighbours>::solve(const SignalCovariance& model) {
  const double variance_db2 = model.shadowing_db * model.shadowing_db;
  const double rate = -1.0 / model.shadowing_distance_m;
  const auto shared = [&](std::size_t i, std::size_t j) -> Lanes {
    const Lanes distance = ((x_[i] - x_[j]).square() + (y_[i] - y_[j]).square()).sqrt();
    return variance_db2 * known_[i] * known_[j] * (rate * distance).exp();
  };
  // Factors into L D L' and solves forwards; `row` holds L D, `factor_` holds L.
  Lanes left = variance_db2 + own_[0];
  for (std::size_t i = 0; i < kNeighbours; ++i) {
    Lanes pivot = variance_db2 + own_[i + 1];
    Lanes forwards = shared(i + 1, 0);
    std::array<Lanes, kNeighbours> row;
    for (std::size_t j = 0; j < i; ++j) {
      row[j] = shared(i + 1, j + 1);
      for (std::size_t k = 0; k < j; ++k) {
        row[j] -= row[k] * factor_[j][k];
      }
      factor_[i][j] = row[j] * inverse_pivot_[j];
      pivot -= row[j] * factor_[i][j];
      forwards -= factor_[i][j] * weight_[j];
    }
    // A conditional variance is at least the position's own. Rounding could make it smaller where
    // positions coincide.
    inverse_pivot_[i] = pivot.max(own_[i + 1]).inverse();
    weight_[i] = forwards;
    left -= forwards.square() * inverse_pivot_[i];
  }
  for (std::size_t i = kNeighbours; i-- > 0;) {
    weight_[i] *= inverse_pivot_[i];
    for (std::size_t j = i + 1; j < kNeighbours; ++j) {
      weight_[i] -= factor_[j][i] * weight_[j];
    }
  }
  scale_ = left.max(own_[0]).sqrt().inverse();
}

}  // namespace sfw
