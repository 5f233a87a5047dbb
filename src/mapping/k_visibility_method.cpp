#include <utility>

#include "k_visibility/rssi_filter.h"
#include "k_visibility/sparse_inverse.h"
#include "k_visibility/wall_count_model.h"
#include "mapping/map_method.h"

namespace sfw {
namespace {

std::vector<double> filtered(const std::vector<Sample>& samples, const Position& access_point,
                             const Config::KVisibility& config) {
  std::vector<double> rssi_dbm;
  rssi_dbm.reserve(samples.size());
  for (const Sample& sample : samples) {
    const double distance_m = (sample.antenna_in_map - access_point).norm();
    rssi_dbm.push_back(withoutPathLoss(sample.rssi_dbm, distance_m, config.path_loss_exponent));
  }
  const auto window = static_cast<std::size_t>(config.window);
  return config.filter == "mean" ? slidingMean(rssi_dbm, window) : slidingMedian(rssi_dbm, window);
}

WallCountModel fitted(const std::vector<double>& rssi_dbm, const Config::KVisibility& config) {
  return config.wall_count > 0
             ? WallCountModel::fit(rssi_dbm, static_cast<std::size_t>(config.wall_count))
             : WallCountModel::choose(rssi_dbm, static_cast<std::size_t>(config.max_wall_count),
                                      config.min_wall_loss_db);
}

/// Wall counts from signal strengths, then sparse inverse k-visibility
/// (doc/method/k_visibility.md).
class KVisibilityMethod : public MapMethod {
 public:
  explicit KVisibilityMethod(const Config& config) : config_(config) {}

  MethodResult infer(const GridGeometry& geometry, const Inliers& inliers,
                     const std::vector<AccessPointSummary>& access_points, UseRadio use_radio,
                     const std::atomic<bool>& stop) const override {
    std::vector<CountedPath> counted_paths;
    std::vector<std::vector<int>> walls(access_points.size());
    std::vector<WallCountClusters> clusters;
    for (std::size_t i = 0; i < access_points.size(); ++i) {
      const std::vector<Sample> samples =
          isPlaced(access_points[i]) ? inliers.readings[i].samples : std::vector<Sample>();
      const Position& access_point = access_points[i].access_point.position;
      const std::vector<double> rssi_dbm = filtered(samples, access_point, config_.k_visibility);
      const WallCountModel model = fitted(rssi_dbm, config_.k_visibility);
      CountedPath counted{access_point, {}};
      for (std::size_t j = 0; j < samples.size(); ++j) {
        walls[i].push_back(model.count(rssi_dbm[j]));
        counted.poses.push_back({samples[j].antenna_in_map, walls[i].back()});
      }
      clusters.push_back({model.centroids(), model.thresholds()});
      counted_paths.push_back(std::move(counted));
    }
    if (use_radio == UseRadio::kNo) {
      counted_paths.clear();
    }
    Grid<float> occupied = inferOccupancy(geometry, counted_paths, positionsOf(inliers.path),
                                          inliers.contacts, sparseInverseConfig(config_), stop);
    return {occupied, occupied, std::move(walls), std::move(clusters), {}};
  }

 private:
  Config config_;
};

}  // namespace

std::unique_ptr<const MapMethod> makeKVisibilityMethod(const Config& config) {
  return std::make_unique<KVisibilityMethod>(config);
}

}  // namespace sfw
