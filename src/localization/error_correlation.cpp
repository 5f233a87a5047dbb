#include "localization/error_correlation.h"

#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

/// Errors of each radio, by column, in each scan, by row, in deviations of the prediction.
struct Errors {
  Eigen::MatrixXf deviations;  // 0: not heard
  Eigen::MatrixXf known;       // 1 or 0
};

constexpr double kLimit = 3.0;  // larger errors are outliers

/// Adds the errors of a radio in the scans of one fold, predicted from the other.
void addErrors(const MappedRadio& radio, const std::vector<Scan>& scans,
               const std::vector<int>& folds, int fold, std::size_t stride, Eigen::Index column,
               Errors& errors) {
  std::vector<bool> used;
  for (const int one : folds) {
    used.push_back(one != fold);
  }
  std::vector<Position> positions;
  std::vector<double> rssi_dbm;
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < radio.scans.size(); ++i) {
    const std::size_t scan = radio.scans[i];
    if (folds[scan] == fold && scan % stride == 0) {
      positions.push_back(scans[scan].position);
      rssi_dbm.push_back(radio.rssi_dbm[i]);
      rows.push_back(static_cast<Eigen::Index>(scan / stride));
    }
  }
  const std::vector<Sample> samples = samplesOf(radio, scans, used);
  if (samples.empty() || positions.empty()) {
    return;
  }
  const SignalPrediction predicted = SignalField(samples, radio.law).predict(positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double error = (rssi_dbm[i] - predicted.mean_dbm[i]) / predicted.deviation_db[i];
    errors.deviations(rows[i], column) = static_cast<float>(std::clamp(error, -kLimit, kLimit));
    errors.known(rows[i], column) = 1.0F;
  }
}

float certain(float found, float count) {
  constexpr float kFewTogether = 20.0F;
  constexpr float kStandardErrors = 2.0F;
  return found > kStandardErrors / std::sqrt(count) ? found * count / (count + kFewTogether) : 0.0F;
}

}  // namespace

Eigen::MatrixXf errorCorrelation(const std::vector<MappedRadio>& radios,
                                 const std::vector<Scan>& scans, const std::vector<int>& folds,
                                 const std::atomic<bool>* stop) {
  constexpr std::size_t kMostScans = 2000;
  const std::size_t stride = (scans.size() + kMostScans - 1) / kMostScans;
  const auto count = static_cast<Eigen::Index>(radios.size());
  Errors errors;
  errors.deviations.setZero(static_cast<Eigen::Index>((scans.size() + stride - 1) / stride), count);
  errors.known = errors.deviations;
  for (Eigen::Index i = 0; i < count && !isStopped(stop); ++i) {
    for (const int fold : {0, 1}) {
      addErrors(radios[static_cast<std::size_t>(i)], scans, folds, fold, stride, i, errors);
    }
  }
  const Eigen::MatrixXf products = errors.deviations.transpose() * errors.deviations;
  const Eigen::MatrixXf squares = errors.deviations.cwiseAbs2().transpose() * errors.known;
  const Eigen::MatrixXf together = errors.known.transpose() * errors.known;
  Eigen::MatrixXf correlation = Eigen::MatrixXf::Identity(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const float norm = std::sqrt(squares(i, j) * squares(j, i));
      if (i != j && norm > 0.0F) {
        correlation(i, j) = certain(products(i, j) / norm, together(i, j));
      }
    }
  }
  return correlation;
}

}  // namespace sfw
