#include "localization/signal_field.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "localization/local_kriging.h"
#include "localization/signal_bins.h"
#include "radio/shadowing.h"

namespace sfw {

SignalField::SignalField(const std::vector<Sample>& samples, const SignalLaw& law) : law_(law) {
  const SignalBins bins = signalBins(samples);
  positions_ = bins.positions;
  const auto count = static_cast<Eigen::Index>(positions_.size());
  residual_.resize(count);
  basis_.resize(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto bin = static_cast<std::size_t>(i);
    noise_db2_.push_back(law_.noise_db2 / bins.readings[bin]);
    basis_.row(i) = signalBasis(law_, positions_[bin]).transpose();
    residual_[i] = bins.rssi_dbm[bin] - priorMean(law_, positions_[bin]);
  }
  fitMean();
  distrustOutliers();
}

void SignalField::fitMean() {
  const ShadowingWhitener whitener(positions_, noise_db2_, law_.covariance);
  const Eigen::MatrixX2d white_basis = whitener.whitened(basis_);
  const Eigen::VectorXd white = whitener.whitened(residual_);
  coefficients_variance_ =
      (Eigen::Matrix2d::Identity() + white_basis.transpose() * white_basis).inverse();
  coefficients_ = coefficients_variance_ * (white_basis.transpose() * white);
  around_mean_ = residual_ - basis_ * coefficients_;
}

/// A bin that its neighbours miss by more than three deviations gets as much noise as makes it
/// three.
void SignalField::distrustOutliers() {
  constexpr double kLimit = 3.0;
  constexpr std::size_t kFewestBins = 6;
  if (positions_.size() < kFewestBins) {
    return;
  }
  std::vector<double> noise_db2 = noise_db2_;
  LocalKriging kriging(positions_, noise_db2_, law_.covariance);
  const int count = static_cast<int>(positions_.size());
  for (int first = 0; first < count; first += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const int own = std::min(first + lane, count - 1);
      const auto bin = static_cast<std::size_t>(own);
      kriging.set(lane, positions_[bin], noise_db2_[bin] + law_.covariance.nugget_db2, own);
    }
    kriging.solve();
    for (int lane = 0; lane < std::min(kLanes, count - first); ++lane) {
      double error = around_mean_[first + lane];
      for (int j = 0; j < LocalKriging::kNeighbours; ++j) {
        error -= kriging.weight(lane, j) * around_mean_[kriging.bin(lane, j)];
      }
      const double variance = kriging.deviation(lane) * kriging.deviation(lane);
      noise_db2[static_cast<std::size_t>(first + lane)] +=
          std::max(0.0, error * error / (kLimit * kLimit) - variance);
    }
  }
  noise_db2_ = noise_db2;
  fitMean();
}

SignalPrediction SignalField::predict(const std::vector<Position>& positions) const {
  SignalPrediction result;
  LocalKriging kriging(positions_, noise_db2_, law_.covariance);
  const double own_db2 = law_.noise_db2 + law_.covariance.nugget_db2;
  for (std::size_t first = 0; first < positions.size(); first += kLanes) {
    const std::size_t lanes = std::min<std::size_t>(kLanes, positions.size() - first);
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t number = first + std::min(static_cast<std::size_t>(lane), lanes - 1);
      kriging.set(lane, positions[number], own_db2);
    }
    kriging.solve();
    for (int lane = 0; lane < static_cast<int>(lanes); ++lane) {
      const Position& position = positions[first + static_cast<std::size_t>(lane)];
      Eigen::Vector2d basis = signalBasis(law_, position);
      double mean_dbm = priorMean(law_, position) + basis.dot(coefficients_);
      for (int j = 0; j < LocalKriging::kNeighbours; ++j) {
        const int bin = kriging.bin(lane, j);
        mean_dbm += kriging.weight(lane, j) * around_mean_[bin];
        basis -= kriging.weight(lane, j) * basis_.row(bin).transpose();
      }
      const double deviation_db = kriging.deviation(lane);
      result.mean_dbm.push_back(mean_dbm);
      result.deviation_db.push_back(
          std::sqrt(deviation_db * deviation_db + basis.dot(coefficients_variance_ * basis)));
    }
  }
  return result;
}

}  // namespace sfw
