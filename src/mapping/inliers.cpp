#include "mapping/inliers.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/erase_if.h"
#include "checks/sentinel_checks.h"
#include "grid/segment.h"
#include "path/poses_between.h"
#include "path/stray_poses.h"

namespace sfw {
namespace {

bool isStampedAlike(const Reading& a, const Reading& b) {
  return a.stamp_ns == b.stamp_ns && a.bssid == b.bssid;
}

/// Counts the readings that are weaker than another one of their radio and stamp, and were taken at
/// another position.
std::size_t countStampedAlike(const std::vector<Reading>& sorted) {
  std::size_t count = 0;
  std::size_t strongest = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (!isStampedAlike(sorted[strongest], sorted[i])) {
      strongest = i;
    } else if (sorted[strongest].antenna_in_map != sorted[i].antenna_in_map) {
      ++count;
    }
  }
  return count;
}

PathPose poseOf(const Reading& reading) {
  return {reading.stamp_ns, reading.antenna_in_map, PathPose::kNoWallCount};
}

std::vector<PathPose> pathOf(const std::vector<Reading>& readings) {
  std::vector<PathPose> path;
  path.reserve(readings.size());
  for (const Reading& reading : readings) {
    path.push_back(poseOf(reading));
  }
  return sortedPath(std::move(path));
}

/// The index of a reading's pose in the path that pathOf made.
std::size_t poseIndex(const Reading& reading, const std::vector<PathPose>& path) {
  return static_cast<std::size_t>(
      std::lower_bound(path.begin(), path.end(), poseOf(reading), isEarlier) - path.begin());
}

/// The index of the pose that is nearest in time.
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

StrayPoses summaryOf(const std::vector<PathPose>& path, const std::vector<bool>& stray) {
  StrayPoses summary;
  const PathPose* inlier = nullptr;  // the last one, or the first one if there is no last yet
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!stray[i]) {
      inlier = &path[i];
      continue;
    }
    if (inlier == nullptr) {
      const auto next = std::find(stray.begin(), stray.end(), false) - stray.begin();
      inlier = &path[static_cast<std::size_t>(next)];
    }
    summary.first_stamp_ns = summary.count == 0 ? path[i].stamp_ns : summary.first_stamp_ns;
    ++summary.count;
    summary.farthest_m =
        std::max(summary.farthest_m, (path[i].antenna_in_map - inlier->antenna_in_map).norm());
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

/// Removes the stray poses of a path, and the readings and contacts at them.
void removeStray(const std::vector<bool>& stray, std::vector<Reading>& readings,
                 std::vector<Contact>& contacts, std::vector<PathPose>& path) {
  eraseIf(readings, [&](const Reading& reading) { return stray[poseIndex(reading, path)]; });
  eraseIf(contacts, [&](const Contact& contact) { return stray[poseAt(contact.stamp_ns, path)]; });
  std::size_t i = 0;
  eraseIf(path, [&](const PathPose&) { return stray[i++]; });
}

std::vector<AccessPointReadings> byAccessPoint(const std::vector<Reading>& readings,
                                               const std::vector<PathPose>& path,
                                               const std::map<Bssid, std::size_t>& index_of) {
  std::vector<AccessPointReadings> all(index_of.size());
  for (const Reading& reading : readings) {
    const auto found = index_of.find(reading.bssid);
    if (found != index_of.end()) {
      AccessPointReadings& one = all[found->second];
      one.samples.push_back({reading.antenna_in_map, reading.rssi_dbm});
      one.poses.push_back(poseIndex(reading, path));
    }
  }
  return all;
}

}  // namespace

void removeDrivenOver(const std::vector<PathPose>& path, double within_m, double max_gap_m,
                      std::vector<Contact>& contacts) {
  eraseIf(contacts, [&](const Contact& contact) {
    for (std::size_t i = path.size(); i > 1 && path[i - 2].stamp_ns > contact.stamp_ns; --i) {
      const Position& from = path[i - 2].antenna_in_map;
      const Position& to = path[i - 1].antenna_in_map;
      if ((to - from).norm() <= max_gap_m &&
          distanceToSegment(contact.point_in_map, from, to) <= within_m) {
        return true;
      }
    }
    return false;
  });
}

void removeSentinels(const std::vector<SentinelFinding>& sentinels,
                     const std::vector<AccessPoint>& table,
                     std::vector<AccessPointReadings>& readings) {
  for (std::size_t i = 0; i < table.size() && !sentinels.empty(); ++i) {
    AccessPointReadings& radio = readings[i];
    AccessPointReadings kept;
    for (std::size_t j = 0; j < radio.samples.size(); ++j) {
      if (!isSentinel(sentinels, table[i].bssid, radio.samples[j].rssi_dbm)) {
        kept.samples.push_back(radio.samples[j]);
        kept.poses.push_back(radio.poses[j]);
      }
    }
    radio = std::move(kept);
  }
}

void removeRepeated(std::vector<AccessPointReadings>& readings) {
  constexpr double kDrives = 0.005;  // [m] from one reading to the next
  for (AccessPointReadings& radio : readings) {
    AccessPointReadings kept;
    for (std::size_t j = 0; j < radio.samples.size(); ++j) {
      const Sample& sample = radio.samples[j];
      const bool is_repeated =
          j > 0 && sample.rssi_dbm == radio.samples[j - 1].rssi_dbm &&
          (sample.antenna_in_map - radio.samples[j - 1].antenna_in_map).norm() >= kDrives;
      if (!is_repeated) {
        kept.samples.push_back(sample);
        kept.poses.push_back(radio.poses[j]);
      }
    }
    radio = std::move(kept);
  }
}

std::vector<Position> positionsOf(const std::vector<PathPose>& path) {
  std::vector<Position> positions;
  positions.reserve(path.size());
  for (const PathPose& pose : path) {
    positions.push_back(pose.antenna_in_map);
  }
  return positions;
}

std::vector<Reading> sortedByStamp(std::vector<Reading> readings) {
  const auto full_order = [](const Reading& r) {
    return std::make_tuple(r.stamp_ns, r.bssid, -r.rssi_dbm, r.antenna_in_map.x(),
                           r.antenna_in_map.y());
  };
  std::sort(readings.begin(), readings.end(),
            [&](const Reading& a, const Reading& b) { return full_order(a) < full_order(b); });
  return readings;
}

std::vector<Reading> strongestOfEachStamp(std::vector<Reading> sorted) {
  sorted.erase(std::unique(sorted.begin(), sorted.end(), isStampedAlike), sorted.end());
  return sorted;
}

Inliers withoutStrayPoses(std::vector<Reading> sorted, std::vector<Contact> contacts,
                          const std::map<Bssid, std::size_t>& index_of,
                          const std::vector<PathPose>& poses) {
  Inliers inliers;
  inliers.stamped_alike = countStampedAlike(sorted);
  std::vector<Reading> readings = strongestOfEachStamp(std::move(sorted));
  inliers.contacts = std::move(contacts);
  inliers.path = pathOf(readings);
  const std::vector<bool> stray = strayPoses(inliers.path);
  inliers.stray = summaryOf(inliers.path, stray);
  const std::vector<PathPose> between = posesBetween(inliers.path, stray, sortedPath(poses));
  if (inliers.stray.count > 0) {
    removeStray(stray, readings, inliers.contacts, inliers.path);
  }
  inliers.motion = motionOf(inliers.path);
  inliers.path.insert(inliers.path.end(), between.begin(), between.end());
  inliers.path = sortedPath(std::move(inliers.path));
  inliers.readings = byAccessPoint(readings, inliers.path, index_of);
  return inliers;
}

}  // namespace sfw
