#include "localization/place_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sfw {

PlaceEstimate estimateOf(const std::vector<Position>& positions,
                         const std::vector<double>& weights) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  PlaceEstimate estimate;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    estimate.position += weights[i] / total * positions[i];
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Position error = positions[i] - estimate.position;
    estimate.covariance += error * (weights[i] / total * error).transpose();
    if (error.norm() <= kSureWithinM) {
      estimate.sure += weights[i] / total;
    }
  }
  estimate.covariance(1, 0) = estimate.covariance(0, 1);  // equal but for rounding
  return estimate;
}

std::vector<double> posterior(const PlaceLattice& places,
                              const std::vector<double>& log_likelihood) {
  std::vector<double> result(places.size());
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = log_likelihood[i] + places.logPrior()[i];
    most = std::max(most, result[i]);
  }
  double sum = 0.0;
  for (double& value : result) {
    value = std::exp(value - most);
    sum += value;
  }
  for (double& value : result) {
    value /= sum;
  }
  return result;
}

}  // namespace sfw
