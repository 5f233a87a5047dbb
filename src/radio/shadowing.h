#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "radio/radio_bins.h"
#include "radio/signal_covariance.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Inverse covariance of spatially correlated RSSI variation that no wall causes (shadow fading).
///
/// The covariance K is that of SignalCovariance without the terms of power and exponent. Its
/// inverse is L' L by Vecchia's approximation (1988): each row of L predicts one position from its
/// nearest ones among the positions before it. Memory and each product are linear in positions.
class ShadowingWhitener {
 public:
  /// The positions that predict each position. They do not depend on the covariance, so whiteners
  /// of the same positions can share them.
  class Neighbours;

  /// @param positions  [m], any frame
  /// @param noise_db2  variance of each position's mean signal; positive together with the nugget
  /// @param model      its priors of power and exponent are not used
  ShadowingWhitener(const std::vector<Position>& positions, const std::vector<double>& noise_db2,
                    const SignalCovariance& model);

  /// As above, with the neighbours of these positions.
  ShadowingWhitener(const std::vector<Position>& positions, const std::vector<double>& noise_db2,
                    const SignalCovariance& model, const Neighbours& neighbours);

  /// As above for the bins of an access point.
  ShadowingWhitener(const AccessPointBins& access_point, const SignalCovariance& model)
      : ShadowingWhitener(positionsOf(access_point), noiseOfMeans(access_point), model) {}

  /// L v: independent and of variance 1 if K is the covariance of v. O(positions).
  /// @param values  one row for each position, any number of columns
  template <class Values>
  Values whitened(const Values& values) const;

  /// K^-1 v = L' L v. O(positions).
  Eigen::VectorXd applyPrecision(const Eigen::VectorXd& values) const;

  /// Logarithm of the determinant of L.
  double logDeterminant() const;

  /// With 12 neighbours, the variance of most sums of signals is right within a seventh. The
  /// variance of the worst sum is right within a half. Shadowing itself is known less accurately.
  static constexpr int kNeighbours = 12;

  /// One row of the factor L: a position itself, then its neighbours. A row with fewer neighbours
  /// repeats the position itself with weight 0.
  template <class Scalar>
  struct Row {
    std::array<int, kNeighbours + 1> index;
    std::array<Scalar, kNeighbours + 1> weight;
  };

  /// The rows of L, from coarse to fine.
  const std::vector<Row<double>>& rows() const { return rows_; }

 private:
  std::vector<Row<double>> rows_;
};

class ShadowingWhitener::Neighbours {
 public:
  /// @param positions  [m], any frame
  explicit Neighbours(const std::vector<Position>& positions);

 private:
  friend class ShadowingWhitener;

  std::vector<std::array<int, kNeighbours + 1>> index_;  // as of Row
  std::vector<int> known_;                               // how many each row has
};

/// Inverse covariance of the signals of one access point, for unknown power and exponent, and for a
/// position that is known or estimated.
///
/// The covariance is all of SignalCovariance, so power and path loss exponent are marginalised, not
/// estimated. So is the position, by the derivative of the signals' mean. ShadowingWhitener
/// approximates K; the other terms, of rank two to four, are exact (Woodbury).
class SignalPrecision {
 public:
  /// @param positions        [m], any frame
  /// @param noise_db2        variance of each position's mean signal; positive with the nugget
  /// @param basis            of the other terms: one row for each position, one column for each
  /// term,
  ///                         scaled by the standard deviation of its coefficient
  SignalPrecision(const std::vector<Position>& positions, const std::vector<double>& noise_db2,
                  const Eigen::MatrixXd& basis, const SignalCovariance& model);

  /// As above for the bins of an access point.
  SignalPrecision(const AccessPointBins& access_point, const SignalCovariance& model);

  /// C^-1 r. O(positions).
  Eigen::VectorXd times(const Eigen::VectorXd& residual) const;

 private:
  friend class SignalPrecisionF;

  ShadowingWhitener whitener_;
  Eigen::MatrixXd solved_basis_;  // K^-1 U
  Eigen::MatrixXd capacitance_;   // (W^-1 + U' K^-1 U)^-1
};

/// A SignalPrecision in single-precision numbers (float).
///
/// Its products take half the time, with a relative error of about 1e-6.
class SignalPrecisionF {
 public:
  explicit SignalPrecisionF(const SignalPrecision& exact);

  /// Sets `product` to C^-1 r. O(positions).
  void times(const Eigen::Ref<const Eigen::VectorXf>& residual,
             Eigen::Ref<Eigen::VectorXf> product) const;

 private:
  std::vector<ShadowingWhitener::Row<float>> rows_;
  Eigen::MatrixXf solved_basis_;
  Eigen::MatrixXf capacitance_;
};

template <class Values>
Values ShadowingWhitener::whitened(const Values& values) const {
  Values white(values.rows(), values.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row<double>& row = rows_[i];
    auto sum = white.row(static_cast<Eigen::Index>(i));
    sum = row.weight[0] * values.row(row.index[0]);
    for (std::size_t j = 1; j < row.index.size(); ++j) {
      sum += row.weight[j] * values.row(row.index[j]);
    }
  }
  return white;
}

}  // namespace sfw
