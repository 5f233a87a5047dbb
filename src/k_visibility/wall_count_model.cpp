#include "k_visibility/wall_count_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sfw {
namespace {

/// Counts and prefix sums of values in bins of 0.1 dB. The prefix sums give the cost of a cut in
/// O(1). The bins keep the clustering's cost from growing with the number of readings.
class Histogram {
 public:
  explicit Histogram(const std::vector<double>& rssi_dbm) {
    std::vector<long> bins;
    bins.reserve(rssi_dbm.size());
    for (const double value : rssi_dbm) {
      bins.push_back(std::lround(value * kBinsPerDb));
    }
    std::sort(bins.begin(), bins.end());
    for (const long bin : bins) {
      const double value = static_cast<double>(bin) / kBinsPerDb;
      if (values_.empty() || values_.back() != value) {
        values_.push_back(value);
        count_.push_back(count_.back());
        sum_.push_back(sum_.back());
        squares_.push_back(squares_.back());
      }
      count_.back() += 1.0;
      sum_.back() += value;
      squares_.back() += value * value;
    }
  }

  std::size_t size() const { return values_.size(); }
  double value(std::size_t bin) const { return values_[bin]; }
  double count(std::size_t bin) const { return count_[bin + 1] - count_[bin]; }
  double mean(std::size_t begin, std::size_t end) const {
    return (sum_[end] - sum_[begin]) / (count_[end] - count_[begin]);
  }
  /// Sum of squared distances of bins [begin, end) from their mean.
  double scatter(std::size_t begin, std::size_t end) const {
    const double sum = sum_[end] - sum_[begin];
    return squares_[end] - squares_[begin] - sum * sum / (count_[end] - count_[begin]);
  }

 private:
  static constexpr double kBinsPerDb = 10.0;

  std::vector<double> values_;
  std::vector<double> count_{0.0}, sum_{0.0}, squares_{0.0};  // prefix sums, one longer
};

/// Centroids, ascending, of the cut of the histogram into `groups` intervals with least scatter.
std::vector<double> bestCentroids(const Histogram& histogram, std::size_t groups) {
  const std::size_t bins = histogram.size();
  groups = std::min(groups, bins);
  // cost[n]: least scatter of the first n bins in g groups; begin[g][n]: start of the last group.
  std::vector<double> cost(bins + 1, std::numeric_limits<double>::infinity());
  cost[0] = 0.0;
  std::vector<std::vector<std::size_t>> begin(groups + 1, std::vector<std::size_t>(bins + 1, 0));
  for (std::size_t g = 1; g <= groups; ++g) {
    std::vector<double> next(bins + 1, std::numeric_limits<double>::infinity());
    for (std::size_t end = g; end <= bins; ++end) {
      for (std::size_t b = g - 1; b < end; ++b) {
        const double candidate = cost[b] + histogram.scatter(b, end);
        if (candidate < next[end]) {
          next[end] = candidate;
          begin[g][end] = b;
        }
      }
    }
    cost = std::move(next);
  }
  std::vector<double> centroids(groups);
  for (std::size_t g = groups, end = bins; g > 0; end = begin[g][end], --g) {
    centroids[g - 1] = histogram.mean(begin[g][end], end);
  }
  return centroids;
}

std::vector<double> descending(std::vector<double> centroids) {
  std::reverse(centroids.begin(), centroids.end());
  return centroids;
}

double leastGap(const std::vector<double>& ascending) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < ascending.size(); ++i) {
    least = std::min(least, ascending[i] - ascending[i - 1]);
  }
  return least;
}

/// The mean silhouette: it measures how much nearer values are to their own centroid than to the
/// next one, 0 to 1.
double meanSilhouette(const Histogram& histogram, const std::vector<double>& centroids) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t bin = 0; bin < histogram.size(); ++bin) {
    const double value = histogram.value(bin);
    std::vector<double> distances;
    distances.reserve(centroids.size());
    for (const double centroid : centroids) {
      distances.push_back(std::abs(value - centroid));
    }
    std::partial_sort(distances.begin(), distances.begin() + 2, distances.end());
    sum += histogram.count(bin) * (1.0 - distances[0] / distances[1]);
    count += histogram.count(bin);
  }
  return sum / count;
}

}  // namespace

WallCountModel::WallCountModel(std::vector<double> centroids_dbm)
    : centroids_dbm_(std::move(centroids_dbm)) {
  for (std::size_t k = 1; k < centroids_dbm_.size(); ++k) {
    thresholds_dbm_.push_back((centroids_dbm_[k - 1] + centroids_dbm_[k]) / 2.0);
  }
}

WallCountModel WallCountModel::fit(const std::vector<double>& rssi_dbm, std::size_t walls) {
  return WallCountModel(descending(bestCentroids(Histogram(rssi_dbm), walls + 1)));
}

WallCountModel WallCountModel::choose(const std::vector<double>& rssi_dbm, std::size_t max_walls,
                                      double min_wall_loss_db) {
  const Histogram histogram(rssi_dbm);
  std::vector<double> chosen = bestCentroids(histogram, 1);
  double best = 0.0;
  for (std::size_t walls = 1; walls <= max_walls && walls < histogram.size(); ++walls) {
    std::vector<double> centroids = bestCentroids(histogram, walls + 1);
    const double silhouette = meanSilhouette(histogram, centroids);
    if (leastGap(centroids) >= min_wall_loss_db && silhouette > best) {
      best = silhouette;
      chosen = std::move(centroids);
    }
  }
  return WallCountModel(descending(std::move(chosen)));
}

int WallCountModel::count(double rssi_dbm) const {
  const auto weaker = std::find_if(thresholds_dbm_.begin(), thresholds_dbm_.end(),
                                   [&](double threshold) { return rssi_dbm > threshold; });
  return static_cast<int>(weaker - thresholds_dbm_.begin());
}

}  // namespace sfw
