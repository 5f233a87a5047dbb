#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "belief/fused_belief.h"
#include "k_visibility/sparse_inverse.h"
#include "mapping/reading_order.h"
#include "path/stray_poses.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {
namespace {

auto order(const PathPose& pose) {
  return std::make_tuple(pose.stamp_ns, pose.antenna_in_map.x(), pose.antenna_in_map.y());
}

bool earlier(const PathPose& a, const PathPose& b) { return order(a) < order(b); }

/// Every pose once, in the order driven.
std::vector<PathPose> pathOf(const std::vector<Reading>& readings) {
  std::vector<PathPose> path;
  path.reserve(readings.size());
  for (const Reading& reading : readings) {
    path.push_back({reading.stamp_ns, reading.antenna_in_map, PathPose::kNothingHeard});
  }
  std::sort(path.begin(), path.end(), earlier);
  path.erase(std::unique(path.begin(), path.end(),
                         [](const PathPose& a, const PathPose& b) { return order(a) == order(b); }),
             path.end());
  return path;
}

/// What is told of the stray ones of a path.
StrayPoses summaryOf(const std::vector<PathPose>& path, const std::vector<bool>& stray) {
  StrayPoses summary;
  const PathPose* believed = nullptr;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!stray[i]) {
      believed = &path[i];
      continue;
    }
    if (believed == nullptr) {
      const auto next = std::find(stray.begin(), stray.end(), false) - stray.begin();
      believed = &path[static_cast<std::size_t>(next)];
    }
    summary.first_stamp_ns = summary.count == 0 ? path[i].stamp_ns : summary.first_stamp_ns;
    ++summary.count;
    summary.farthest_m =
        std::max(summary.farthest_m, (path[i].antenna_in_map - believed->antenna_in_map).norm());
  }
  return summary;
}

PathMotion motionOf(const std::vector<PathPose>& path) {
  PathMotion motion;
  motion.usual_speed_m_s = usualSpeed(path);
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (!isReachable(path[i - 1], path[i], motion.usual_speed_m_s)) {
      motion.first_jump_stamp_ns =
          motion.jumps == 0 ? path[i].stamp_ns : motion.first_jump_stamp_ns;
      ++motion.jumps;
      motion.farthest_jump_m = std::max(
          motion.farthest_jump_m, (path[i].antenna_in_map - path[i - 1].antenna_in_map).norm());
    }
  }
  return motion;
}

std::size_t countAtZero(const std::vector<double>& rssi_dbm) {
  constexpr double kStrongest = -0.5;  // [dBm], half a step of most radios below 0
  return static_cast<std::size_t>(std::count_if(rssi_dbm.begin(), rssi_dbm.end(),
                                                [](double rssi) { return rssi > kStrongest; }));
}

/// The pose of a path that is nearest in time.
std::size_t poseAt(std::int64_t stamp_ns, const std::vector<PathPose>& path) {
  const auto next = std::lower_bound(
      path.begin(), path.end(), stamp_ns,
      [](const PathPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  const auto i = static_cast<std::size_t>(next - path.begin());
  if (i == 0) {
    return 0;
  }
  return i == path.size() || stamp_ns - path[i - 1].stamp_ns <= path[i].stamp_ns - stamp_ns ? i - 1
                                                                                            : i;
}

std::vector<Position> positionsOf(const std::vector<PathPose>& path) {
  std::vector<Position> positions;
  positions.reserve(path.size());
  for (const PathPose& pose : path) {
    positions.push_back(pose.antenna_in_map);
  }
  return positions;
}

/// Notes a wall count at its pose of the path; of several, the smallest stays.
void noteWalls(const PathPose& counted, std::vector<PathPose>& path) {
  const auto at = std::lower_bound(path.begin(), path.end(), counted, earlier);
  at->walls =
      at->walls == PathPose::kNothingHeard ? counted.walls : std::min(at->walls, counted.walls);
}

double deviationOf(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::ArrayXd> all(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  return values.empty() ? 0.0 : std::sqrt((all - all.mean()).square().mean());
}

/// Walls that would lose as much, each what an interior wall usually takes (ns-3's default).
int wallsOf(double loss_db) {
  constexpr double kUsualWall = 5.0;  // [dB]
  return static_cast<int>(std::lround(loss_db / kUsualWall));
}

}  // namespace

Mapper::Inliers Mapper::believed() const {
  std::vector<Reading> every = sorted();
  const std::size_t stamped_alike = countStampedAlike(every);
  Inliers believed{{}, strongestOfEachStamp(std::move(every)), contacts_, {}, stamped_alike};
  std::vector<PathPose> path = pathOf(believed.readings);
  const std::vector<bool> stray = strayPoses(path);
  believed.stray = summaryOf(path, stray);
  if (believed.stray.count == 0) {
    believed.path = std::move(path);
    return believed;
  }
  const auto recordRejected = [](auto& all, auto&& is_stray) {
    all.erase(std::remove_if(all.begin(), all.end(), is_stray), all.end());
  };
  recordRejected(believed.readings, [&](const Reading& reading) {
    const PathPose pose{reading.stamp_ns, reading.antenna_in_map, PathPose::kNothingHeard};
    return stray[static_cast<std::size_t>(
        std::lower_bound(path.begin(), path.end(), pose, earlier) - path.begin())];
  });
  recordRejected(believed.contacts,
                 [&](const Contact& contact) { return stray[poseAt(contact.stamp_ns, path)]; });
  believed.path = pathOf(believed.readings);
  return believed;
}

std::vector<Mapper::Series> Mapper::seriesOf(const std::vector<Reading>& readings) const {
  std::vector<Series> all(access_points_.size());
  for (const Reading& reading : readings) {
    const auto found = index_of_.find(reading.bssid);
    if (found != index_of_.end()) {
      Series& series = all[found->second];
      series.poses.push_back({reading.stamp_ns, reading.antenna_in_map, PathPose::kNothingHeard});
      series.rssi_dbm.push_back(reading.rssi_dbm);
    }
  }
  return all;
}

std::shared_ptr<const Snapshot> Mapper::infer() const {
  const std::atomic<bool> never{false};
  return infer(never);
}

std::shared_ptr<const Snapshot> Mapper::infer(const std::atomic<bool>& stop) const {
  return infer(UseRadio::kSignals, stop);
}

std::shared_ptr<const Snapshot> Mapper::inferWithoutRadio() const {
  const std::atomic<bool> never{false};
  return infer(UseRadio::kNothing, never);
}

std::shared_ptr<const Snapshot> Mapper::infer(UseRadio hearing,
                                              const std::atomic<bool>& stop) const {
  const Inliers known = believed();
  Snapshot snapshot{
      BeliefMap(geometryOf(extentOf(known)), config_.belief), known.path, {}, rejections_};
  snapshot.stray = known.stray;
  snapshot.motion = motionOf(snapshot.path);
  snapshot.stamped_alike = known.stamped_alike;
  std::vector<Series> heard = seriesOf(known.readings);
  snapshot.access_points = placed(heard, stop);
  if (config_.method == "tomography") {
    inferByTomography(heard, hearing, known.contacts, stop, snapshot);
  } else {
    inferByCounts(heard, hearing, known.contacts, stop, snapshot);
  }
  return stop ? nullptr : std::make_shared<const Snapshot>(std::move(snapshot));
}

std::vector<Sample> Mapper::samplesOf(const Series& series) {
  std::vector<Sample> samples;
  samples.reserve(series.poses.size());
  for (std::size_t i = 0; i < series.poses.size(); ++i) {
    samples.push_back({series.poses[i].antenna_in_map, series.rssi_dbm[i]});
  }
  return samples;
}

std::vector<AccessPointSummary> Mapper::placed(std::vector<Series>& heard,
                                               const std::atomic<bool>& stop) const {
  std::vector<AccessPointSummary> summaries;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    AccessPointSummary summary{access_points_[i], heard[i].poses.size(), {}};
    summary.rssi_deviation_db = deviationOf(heard[i].rssi_dbm);
    summary.at_zero_dbm = countAtZero(heard[i].rssi_dbm);
    AccessPoint& access_point = summary.access_point;
    if (!access_point.position_known && !stop) {
      summary.estimate = estimateAccessPoint(samplesOf(heard[i]), access_point.height_m);
      if (summary.estimate) {
        access_point.position = summary.estimate->position;
      } else {
        heard[i] = {};
      }
    }
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

std::vector<std::vector<Sample>> Mapper::samples() const {
  std::vector<std::vector<Sample>> samples;
  for (const Series& series : seriesOf(believed().readings)) {
    samples.push_back(samplesOf(series));
  }
  return samples;
}

void Mapper::inferByCounts(std::vector<Series>& heard, UseRadio hearing,
                           const std::vector<Contact>& contacts, const std::atomic<bool>& stop,
                           Snapshot& snapshot) const {
  std::vector<CountedPath> counted_paths;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    const Position& access_point = snapshot.access_points[i].access_point.position;
    const std::vector<double> rssi_dbm = filtered(heard[i], access_point);
    const WallCountModel model = fitted(rssi_dbm);
    CountedPath counted{access_point, {}};
    for (std::size_t j = 0; j < rssi_dbm.size(); ++j) {
      PathPose& pose = heard[i].poses[j];
      pose.walls = model.count(rssi_dbm[j]);
      counted.poses.push_back({pose.antenna_in_map, pose.walls});
      noteWalls(pose, snapshot.path);
    }
    snapshot.access_points[i].model = model;
    counted_paths.push_back(std::move(counted));
  }
  if (hearing == UseRadio::kNothing) {
    counted_paths.clear();
  }
  snapshot.belief = BeliefMap(
      inferOccupancy(snapshot.belief.geometry(), counted_paths, positionsOf(snapshot.path),
                     contacts, sparseInverseConfig(config_), stop),
      config_.belief);
}

void Mapper::inferByTomography(std::vector<Series>& heard, UseRadio hearing,
                               const std::vector<Contact>& contacts, const std::atomic<bool>& stop,
                               Snapshot& snapshot) const {
  DriveData drive{positionsOf(snapshot.path), {}, contacts};
  std::vector<std::size_t> index;  // of each access point that is heard
  for (std::size_t i = 0; i < heard.size(); ++i) {
    if (!heard[i].poses.empty()) {
      const AccessPoint& access_point = snapshot.access_points[i].access_point;
      drive.heard.push_back({access_point.position, access_point.height_m, samplesOf(heard[i])});
      index.push_back(i);
    }
  }
  FusedBelief fused = inferOccupancyByTomography(snapshot.belief.geometry(), drive, model_, config_,
                                                 hearing == UseRadio::kSignals, stop);
  for (std::size_t i = 0; i < index.size(); ++i) {
    for (std::size_t j = 0; j < fused.sample_loss[i].size(); ++j) {
      PathPose& pose = heard[index[i]].poses[j];
      pose.walls = wallsOf(fused.sample_loss[i][j]);
      noteWalls(pose, snapshot.path);
    }
  }
  snapshot.belief = BeliefMap(fused.occupied, config_.belief);
  snapshot.tomography =
      TomographySummary{std::move(fused.wall_loss), fused.frame, fused.style, fused.explained};
}

std::vector<double> Mapper::filtered(const Series& series, const Position& access_point) const {
  std::vector<double> rssi_dbm;
  rssi_dbm.reserve(series.poses.size());
  for (std::size_t i = 0; i < series.poses.size(); ++i) {
    const double distance_m = (series.poses[i].antenna_in_map - access_point).norm();
    rssi_dbm.push_back(
        withoutPathLoss(series.rssi_dbm[i], distance_m, config_.k_visibility.path_loss_exponent));
  }
  const auto window = static_cast<std::size_t>(config_.k_visibility.window);
  return config_.k_visibility.filter == "mean" ? slidingMean(rssi_dbm, window)
                                               : slidingMedian(rssi_dbm, window);
}

WallCountModel Mapper::fitted(const std::vector<double>& rssi_dbm) const {
  return config_.k_visibility.wall_count > 0
             ? WallCountModel::fit(rssi_dbm,
                                   static_cast<std::size_t>(config_.k_visibility.wall_count))
             : WallCountModel::choose(rssi_dbm,
                                      static_cast<std::size_t>(config_.k_visibility.max_wall_count),
                                      config_.k_visibility.min_wall_loss_db);
}

}  // namespace sfw
