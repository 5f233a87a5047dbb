#include "localization/temper.h"

#include <cmath>
#include <limits>

namespace sfw {
namespace {

/// Sum of the log posterior probabilities of the true places.
double scoreOf(const Temper& temper, const Eigen::ArrayXf& log_prior,
               const std::vector<CheckedScan>& checked) {
  double sum = 0.0;
  for (const CheckedScan& one : checked) {
    const Eigen::ArrayXf log_posterior = log_prior +
                                         static_cast<float>(temper.signal) * one.evidence.signal +
                                         static_cast<float>(temper.heard) * one.evidence.heard;
    const float most = log_posterior.maxCoeff();
    const float total = (log_posterior - most).exp().sum();
    sum += log_posterior[static_cast<Eigen::Index>(one.true_place)] - most - std::log(total);
  }
  return sum;
}

}  // namespace

std::vector<double> Temper::applied(const ScanEvidence& evidence) const {
  const Eigen::ArrayXd sum =
      signal * evidence.signal.cast<double>() + heard * evidence.heard.cast<double>();
  return {sum.data(), sum.data() + sum.size()};
}

Temper chooseTemper(const PlaceLattice& places, const std::vector<CheckedScan>& checked) {
  constexpr double kChoices[] = {0.0, 0.03, 0.06, 0.12, 0.17, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4, 2.0};
  Temper best;
  if (checked.empty()) {
    return best;
  }
  const Eigen::ArrayXf log_prior =
      Eigen::Map<const Eigen::ArrayXd>(places.logPrior().data(),
                                       static_cast<Eigen::Index>(places.size()))
          .cast<float>();
  double most = -std::numeric_limits<double>::infinity();
  for (const double signal : kChoices) {
    for (const double heard : kChoices) {
      Temper tried;
      tried.signal = signal;
      tried.heard = heard;
      const double score = scoreOf(tried, log_prior, checked);
      if (score > most) {
        most = score;
        best = tried;
      }
    }
  }
  return best;
}

}  // namespace sfw
