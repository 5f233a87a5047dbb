#include "evaluation/localization_evaluation.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

namespace sfw {
namespace {

/// Whether a true position is in the ellipse of 90 %, widened by 0.1 m: poses are no better.
bool holds(const PlaceEstimate& estimate, const Position& truth) {
  constexpr double kChiSquare = 4.605;  // two degrees of freedom
  constexpr double kVarianceOfPoses = 0.01;
  const Position error = truth - estimate.position;
  const Eigen::Matrix2d covariance =
      estimate.covariance + kVarianceOfPoses * Eigen::Matrix2d::Identity();
  return error.dot(covariance.inverse() * error) <= kChiSquare;
}

/// Collects the errors of one method.
class Errors {
 public:
  void add(const Position& estimate, const Position& truth) {
    errors_m_.push_back((estimate - truth).norm());
  }
  void add(const PlaceEstimate& estimate, const Position& truth) {
    add(estimate.position, truth);
    has_ellipses_ = true;
    held_ += holds(estimate, truth) ? 1.0 : 0.0;
  }

  LocalizationErrors summary() {
    LocalizationErrors errors;
    if (errors_m_.empty()) {
      return errors;
    }
    std::sort(errors_m_.begin(), errors_m_.end());
    const auto count = static_cast<double>(errors_m_.size());
    errors.scans = errors_m_.size();
    errors.mean_m = std::accumulate(errors_m_.begin(), errors_m_.end(), 0.0) / count;
    errors.median_m = errors_m_[errors_m_.size() / 2];
    errors.largest_of_90_percent_m = errors_m_[static_cast<std::size_t>(0.9 * (count - 1.0))];
    if (has_ellipses_) {
      errors.in_ellipse = held_ / count;
    }
    return errors;
  }

 private:
  std::vector<double> errors_m_;
  double held_ = 0.0;
  bool has_ellipses_ = false;
};

}  // namespace

std::vector<LocalizedScan> localizeScans(const RadioMap& map, const std::vector<Scan>& scans,
                                         const std::vector<std::optional<Position>>& steps,
                                         const ParticleFilter::Config& config) {
  ParticleFilter filter(map, config);
  std::vector<LocalizedScan> localized;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    LocalizedScan one;
    one.filtered = filter.add(scans[i], steps[i]);
    if (const auto log_likelihood = map.logLikelihood(scans[i])) {
      one.alone = estimateOf(map.places().points(), posterior(map.places(), *log_likelihood));
    }
    localized.push_back(one);
  }
  return localized;
}

LocalizationEvaluation evaluateLocalization(const std::vector<Scan>& scans,
                                            const std::vector<LocalizedScan>& localized,
                                            const NearestFingerprints& fingerprints) {
  Errors filtered;
  Errors alone;
  Errors nearest;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (localized[i].filtered && localized[i].alone) {
      filtered.add(*localized[i].filtered, scans[i].position);
      alone.add(*localized[i].alone, scans[i].position);
      nearest.add(fingerprints.locate(scans[i]), scans[i].position);
    }
  }
  return {filtered.summary(), alone.summary(), nearest.summary()};
}

}  // namespace sfw
