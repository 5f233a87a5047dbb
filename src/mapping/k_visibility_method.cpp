#include <cstdint>
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

/// Where the samples of each robot end: the filter and the path must not join two robots.
std::vector<std::size_t> endsOfRobots(const std::vector<std::uint32_t>& poses,
                                      const std::vector<PathPose>& path) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i <= poses.size(); ++i) {
    if (i == poses.size() || path[poses[i]].robot != path[poses[i - 1]].robot) {
      ends.push_back(i);
    }
  }
  return ends;
}

/// Wall counts from signal strengths, then sparse inverse k-visibility
/// (doc/method/k_visibility.md).
class KVisibilityMethod : public MapMethod {
 public:
  explicit KVisibilityMethod(const Config& config) : config_(config) {}

  MethodResult infer(const GridGeometry& geometry, Inliers& inliers,
                     const std::vector<AccessPointSummary>& access_points, UseRadio use_radio,
                     const std::atomic<bool>& stop, KeptFeatures* /*kept*/) const override {
    std::vector<CountedPath> counted_paths;
    std::vector<std::vector<int>> walls(access_points.size());
    std::vector<WallCountClusters> clusters;
    for (std::size_t i = 0; i < access_points.size(); ++i) {
      const AccessPointReadings readings =
          isPlaced(access_points[i]) ? inliers.readings[i] : AccessPointReadings();
      const std::vector<std::size_t> ends = endsOfRobots(readings.poses, inliers.path);
      const Position& access_point = access_points[i].access_point.position;
      const std::vector<double> rssi_dbm = filteredByRobot(readings.samples, ends, access_point);
      const WallCountModel model = fitted(rssi_dbm, config_.k_visibility);
      CountedPath counted{access_point, {}};
      for (std::size_t j = 0; j < rssi_dbm.size(); ++j) {
        walls[i].push_back(model.count(rssi_dbm[j]));
        counted.poses.push_back({readings.samples[j].antenna_in_map, walls[i].back()});
      }
      for (const std::size_t end : ends) {
        counted.poses[end - 1].is_last = true;
      }
      clusters.push_back({model.centroids(), model.thresholds()});
      counted_paths.push_back(std::move(counted));
    }
    if (use_radio == UseRadio::kNo) {
      counted_paths.clear();
    }
    Grid<float> occupied =
        inferOccupancy(geometry, counted_paths, positionsOf(inliers.path, config_.path.max_gap_m),
                       inliers.contacts, sparseInverseConfig(config_), stop);
    return {occupied, occupied, std::move(walls), std::move(clusters), {}};
  }

 private:
  std::vector<double> filteredByRobot(const std::vector<Sample>& samples,
                                      const std::vector<std::size_t>& ends,
                                      const Position& access_point) const {
    std::vector<double> all;
    for (const std::size_t end : ends) {
      const auto from = samples.begin() + static_cast<std::ptrdiff_t>(all.size());
      const std::vector<double> one =
          filtered({from, samples.begin() + static_cast<std::ptrdiff_t>(end)}, access_point,
                   config_.k_visibility);
      all.insert(all.end(), one.begin(), one.end());
    }
    return all;
  }

  Config config_;
};

}  // namespace

std::unique_ptr<const MapMethod> makeKVisibilityMethod(const Config& config) {
  return std::make_unique<KVisibilityMethod>(config);
}

}  // namespace sfw
