#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Mean of power and log-distance path loss before anything is heard; the priors around it are
/// wide.
constexpr double kPriorPower = -37.0;  ///< [dBm] at 1 m
constexpr double kPriorExponent = 2.1;

/// What differs signals of one access point at several places although no wall does.
struct ShadowingModel {
  double shadowing_db = 1.0;        ///< standard deviation that neighbouring places share
  double shadowing_distance = 1.5;  ///< its correlation falls to 1/e here [m]
  double unexplained_db2 = 1.0;     ///< variance of a place's mean that no other place shares
  double power_db = 20.0;           ///< prior standard deviation of the power at 1 m
  double exponent = 0.35;           ///< prior standard deviation of the path loss exponent
};

/// Makes signals of one access point at many places independent but for power and path loss.
///
/// The covariance is
///   K_ij = shadowing^2 exp(-|p_i - p_j| / distance) + [i = j] (noise_i + unexplained).
/// Its inverse is L' L by Vecchia's approximation (1988): each place given its nearest ones before
/// it, so memory and each product are linear in places.
class ShadowingWhitener {
 public:
  /// @param places     [m], any frame
  /// @param noise_db2  variance of each place's mean signal; with `unexplained_db2` positive
  ShadowingWhitener(const std::vector<Position>& places, const std::vector<double>& noise_db2,
                    const ShadowingModel& model);

  /// L v: of variance 1 and independent if K is the covariance of v. O(places).
  /// @param values  of a place in each row, any number of columns
  template <class Values>
  Values whitened(const Values& values) const;

  /// K^-1 v = L' L v. O(places).
  Eigen::VectorXd applyPrecision(const Eigen::VectorXd& values) const;

  /// Logarithm of the determinant of L.
  double logDeterminant() const;

 private:
  friend class SignalPrecisionF;

  /// With 12 the variance of most sums of signals is right within a seventh, and of the worst one
  /// within a half: far less than what is known of shadowing.
  static constexpr int kNeighbours = 12;

  /// One row of the factor L: a place itself, then places before it. Where there are fewer of
  /// these, the place itself is repeated with weight 0.
  template <class Scalar>
  struct Row {
    std::array<int, kNeighbours + 1> place;
    std::array<Scalar, kNeighbours + 1> weight;
  };

  std::vector<Row<double>> rows_;
};

/// Inverse covariance of the signals of one access point at many places.
///
/// The covariance is
///   C_ij = K_ij + power^2 + exponent^2 h_i h_j
/// so power and path loss exponent are marginalised, not estimated (h = 10 log10 of distance). K is
/// that of ShadowingWhitener; the other terms, of rank two, are exact (Woodbury).
class SignalPrecision {
 public:
  /// @param places     [m], any frame
  /// @param noise_db2  variance of each place's mean signal; with `unexplained_db2` positive
  /// @param loss_db    h of each place
  SignalPrecision(const std::vector<Position>& places, const std::vector<double>& noise_db2,
                  const std::vector<double>& loss_db, const ShadowingModel& model);

  /// C^-1 r. O(places).
  Eigen::VectorXd times(const Eigen::VectorXd& residual) const;

 private:
  friend class SignalPrecisionF;

  ShadowingWhitener whitener_;
  Eigen::MatrixXd solved_basis_;  // K^-1 U, one column for power, one for the exponent
  Eigen::Matrix2d capacitance_;   // (W^-1 + U' K^-1 U)^-1
};

/// A SignalPrecision in single precision: its products take half the time, and err by some 1e-6 of
/// what they are given.
class SignalPrecisionF {
 public:
  explicit SignalPrecisionF(const SignalPrecision& exact);

  /// Sets `product` to C^-1 r. O(places).
  void times(Eigen::Ref<const Eigen::VectorXf> residual, Eigen::Ref<Eigen::VectorXf> product) const;

 private:
  std::vector<ShadowingWhitener::Row<float>> rows_;
  Eigen::Matrix<float, Eigen::Dynamic, 2> solved_basis_;
  Eigen::Matrix2f capacitance_;
};

template <class Values>
Values ShadowingWhitener::whitened(const Values& values) const {
  Values white(values.rows(), values.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row<double>& row = rows_[i];
    auto sum = white.row(static_cast<Eigen::Index>(i));
    sum = row.weight[0] * values.row(row.place[0]);
    for (std::size_t j = 1; j < row.place.size(); ++j) {
      sum += row.weight[j] * values.row(row.place[j]);
    }
  }
  return white;
}

}  // namespace sfw
