#include "mapping/inliers.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <string>
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
  return a.stamp_ns == b.stamp_ns && a.bssid == b.bssid && a.robot == b.robot;
}

/// Counts the readings that are weaker than another one of their radio and stamp, and were taken at
/// another position.
std::size_t countStampedAlike(const ReadingRefs& sorted) {
  std::size_t count = 0;
  std::size_t strongest = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (!isStampedAlike(sorted[strongest], sorted[i])) {
      strongest = i;
    } else if (sorted[strongest].get().antenna_in_map != sorted[i].get().antenna_in_map) {
      ++count;
    }
  }
  return count;
}

PathPose poseOf(const Reading& reading) {
  return {reading.stamp_ns, reading.antenna_in_map, PathPose::kNoWallCount, reading.robot};
}

/// Whether a pose is that of a reading.
bool isAt(const Reading& reading, const PathPose& pose) {
  return reading.stamp_ns == pose.stamp_ns && reading.antenna_in_map == pose.antenna_in_map &&
         reading.robot == pose.robot;
}

std::vector<PathPose> pathOf(const ReadingRefs& readings) {
  const auto isNext = [&](std::size_t i) {  // readings of one scan share a pose
    return i == 0 || !isAt(readings[i], poseOf(readings[i - 1]));
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    count += isNext(i) ? 1 : 0;
  }
  std::vector<PathPose> path;
  path.reserve(count);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (isNext(i)) {
      path.push_back(poseOf(readings[i]));
    }
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

/// Removes the stray poses of a robot's path, and its readings and contacts at them.
void removeStray(const std::vector<bool>& stray, ReadingRefs& readings,
                 std::vector<Contact>& contacts, std::vector<PathPose>& path) {
  eraseIf(readings, [&](const Reading& reading) { return stray[poseIndex(reading, path)]; });
  eraseIf(contacts, [&](const Contact& contact) {
    return contact.robot == path.front().robot && stray[poseAt(contact.stamp_ns, path)];
  });
  std::size_t i = 0;
  eraseIf(path, [&](const PathPose&) { return stray[i++]; });
}

std::vector<AccessPointReadings> byAccessPoint(const ReadingRefs& readings,
                                               const std::vector<PathPose>& path,
                                               const std::map<Bssid, std::size_t>& index_of) {
  std::vector<AccessPointReadings> all(index_of.size());
  std::vector<std::size_t> count(all.size());  // lists that grow would take twice the memory
  for (const Reading& reading : readings) {
    const auto found = index_of.find(reading.bssid);
    if (found != index_of.end()) {
      ++count[found->second];
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].samples.reserve(count[i]);
    all[i].poses.reserve(count[i]);
  }
  std::size_t pose = 0;
  for (const Reading& reading : readings) {
    const auto found = index_of.find(reading.bssid);
    if (found != index_of.end()) {
      AccessPointReadings& one = all[found->second];
      one.samples.push_back({reading.antenna_in_map, reading.rssi_dbm});
      // Most readings share the pose of the one before, or have the next one.
      pose = isAt(reading, path[pose])                                 ? pose
             : pose + 1 < path.size() && isAt(reading, path[pose + 1]) ? pose + 1
                                                                       : poseIndex(reading, path);
      one.poses.push_back(static_cast<std::uint32_t>(pose));
    }
  }
  return all;
}

/// The data of one robot without its stray poses.
struct RobotDrive {
  ReadingRefs readings;
  std::vector<PathPose> path;
  StrayPoses stray;
  PathMotion motion;
};

/// @param readings  of one robot, by stamp
/// @param poses     of the same robot, as sortedPath returns them
/// @param contacts  of all robots; those at stray poses of this one are removed
RobotDrive driveOf(ReadingRefs readings, const std::vector<PathPose>& poses,
                   std::vector<Contact>& contacts) {
  RobotDrive drive;
  drive.readings = std::move(readings);
  drive.path = pathOf(drive.readings);
  const std::vector<bool> stray = strayPoses(drive.path);
  drive.stray = summaryOf(drive.path, stray);
  const std::vector<PathPose> between = posesBetween(drive.path, stray, poses);
  if (drive.stray.count > 0) {
    removeStray(stray, drive.readings, contacts, drive.path);
  }
  drive.motion = motionOf(drive.path);
  drive.path.insert(drive.path.end(), between.begin(), between.end());
  drive.path = sortedPath(std::move(drive.path));
  return drive;
}

std::int64_t earlierOf(std::size_t count, std::int64_t stamp_ns, std::size_t other_count,
                       std::int64_t other_ns) {
  return count == 0 ? other_ns : other_count == 0 ? stamp_ns : std::min(stamp_ns, other_ns);
}

void add(const StrayPoses& other, StrayPoses& sum) {
  sum.first_stamp_ns = earlierOf(sum.count, sum.first_stamp_ns, other.count, other.first_stamp_ns);
  sum.count += other.count;
  sum.farthest_m = std::max(sum.farthest_m, other.farthest_m);
}

void add(const PathMotion& other, PathMotion& sum) {
  sum.first_jump_stamp_ns =
      earlierOf(sum.jumps, sum.first_jump_stamp_ns, other.jumps, other.first_jump_stamp_ns);
  sum.jumps += other.jumps;
  sum.farthest_jump_m = std::max(sum.farthest_jump_m, other.farthest_jump_m);
  sum.usual_speed_m_s = std::max(sum.usual_speed_m_s, other.usual_speed_m_s);
}

/// The items of one robot, in their order.
/// @param robotOf  the robot of an item
template <class Item, class RobotOf>
std::vector<Item> ofRobot(RobotName robot, const std::vector<Item>& items, const RobotOf& robotOf) {
  std::vector<Item> own;
  std::copy_if(items.begin(), items.end(), std::back_inserter(own),
               [&](const Item& item) { return robotOf(item) == robot; });
  return own;
}

/// The first reading of each radio by each robot at each stamp.
ReadingRefs strongestOf(const ReadingRefs& sorted) {
  ReadingRefs strongest;
  strongest.reserve(sorted.size());
  for (const Reading& reading : sorted) {
    if (strongest.empty() || !isStampedAlike(strongest.back(), reading)) {
      strongest.emplace_back(reading);
    }
  }
  return strongest;
}

/// Moves items behind others.
template <class Item>
void append(std::vector<Item>&& items, std::vector<Item>& all) {
  if (all.empty()) {
    all = std::move(items);
  } else {
    std::move(items.begin(), items.end(), std::back_inserter(all));
  }
}

std::set<RobotName> robotsOf(const ReadingRefs& readings) {
  std::set<RobotName> robots;
  for (const Reading& reading : readings) {
    if (robots.empty() || reading.robot != *robots.rbegin()) {
      robots.insert(reading.robot);
    }
  }
  return robots;
}

/// The first pose that is farther than a gap from two others, or nullptr.
const PathPose* poseApart(const std::vector<PathPose>& path, const PathPose& a, const PathPose& b,
                          double max_gap_m) {
  const auto found = std::find_if(path.begin(), path.end(), [&](const PathPose& pose) {
    return (pose.antenna_in_map - a.antenna_in_map).norm() > max_gap_m &&
           (pose.antenna_in_map - b.antenna_in_map).norm() > max_gap_m;
  });
  return found == path.end() ? nullptr : &*found;
}

}  // namespace

void removeDrivenOver(const std::vector<PathPose>& path, double within_m, double max_gap_m,
                      std::vector<Contact>& contacts) {
  eraseIf(contacts, [&](const Contact& contact) {
    for (std::size_t i = path.size(); i > 1; --i) {
      if (path[i - 2].stamp_ns <= contact.stamp_ns || path[i - 2].robot != path[i - 1].robot) {
        continue;
      }
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

std::vector<Position> positionsOf(const std::vector<PathPose>& path, double max_gap_m) {
  std::vector<Position> positions;
  positions.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0 && path[i].robot != path[i - 1].robot) {
      const PathPose* apart = poseApart(path, path[i - 1], path[i], max_gap_m);
      if (apart != nullptr) {
        positions.push_back(apart->antenna_in_map);
      }
    }
    positions.push_back(path[i].antenna_in_map);
  }
  return positions;
}

ReadingRefs sortedByStamp(const std::vector<Reading>& readings) {
  const auto full_order = [](const Reading& r) {
    return std::make_tuple(r.stamp_ns, r.bssid, r.robot, -r.rssi_dbm, r.antenna_in_map.x(),
                           r.antenna_in_map.y());
  };
  const auto isBefore = [&](const Reading& a, const Reading& b) {
    return a.stamp_ns != b.stamp_ns ? a.stamp_ns < b.stamp_ns : full_order(a) < full_order(b);
  };
  ReadingRefs sorted(readings.begin(), readings.end());
  if (!std::is_sorted(sorted.begin(), sorted.end(), isBefore)) {  // they often come sorted
    std::sort(sorted.begin(), sorted.end(), isBefore);
  }
  return sorted;
}

std::vector<Reading> strongestOfEachStamp(const ReadingRefs& sorted) {
  const ReadingRefs strongest = strongestOf(sorted);
  return {strongest.begin(), strongest.end()};
}

InlierReadings readingsWithoutStrayPoses(const ReadingRefs& sorted, std::vector<Contact> contacts,
                                         const std::vector<PathPose>& poses) {
  InlierReadings found;
  Inliers& inliers = found.inliers;
  inliers.stamped_alike = countStampedAlike(sorted);
  ReadingRefs readings = strongestOf(sorted);
  inliers.contacts = std::move(contacts);
  const std::vector<PathPose> sorted_poses = sortedPath(poses);
  const std::set<RobotName> robots = robotsOf(readings);
  const auto robotOfReading = [](const Reading& one) { return one.robot; };
  const auto robotOfPose = [](const PathPose& pose) { return pose.robot; };
  for (const RobotName robot : robots) {
    RobotDrive drive =
        driveOf(robots.size() == 1 ? std::move(readings) : ofRobot(robot, readings, robotOfReading),
                ofRobot(robot, sorted_poses, robotOfPose), inliers.contacts);
    add(drive.stray, inliers.stray);
    add(drive.motion, inliers.motion);
    append(std::move(drive.readings), found.used);
    append(std::move(drive.path), inliers.path);
  }
  return found;
}

Inliers withSamples(InlierReadings readings, const std::map<Bssid, std::size_t>& index_of) {
  Inliers inliers = std::move(readings.inliers);
  inliers.readings = byAccessPoint(readings.used, inliers.path, index_of);
  return inliers;
}

Inliers withoutStrayPoses(const ReadingRefs& sorted, std::vector<Contact> contacts,
                          const std::map<Bssid, std::size_t>& index_of,
                          const std::vector<PathPose>& poses) {
  return withSamples(readingsWithoutStrayPoses(sorted, std::move(contacts), poses), index_of);
}

}  // namespace sfw
