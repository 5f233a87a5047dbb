#include "mapping/reading_store.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/erase_if.h"
#include "base/rssi_range.h"
#include "path/poses_between.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// These steps are finer than the precision of any odometry and radio, and far coarser than
/// rounding.
constexpr double kPositionSteps = 1e4;  // [1/m]
constexpr double kRssiSteps = 1e2;      // [1/dB]

/// The number that text gives when it is read back.
double rounded(double value, double steps) { return std::round(value * steps) / steps; }

Position rounded(const Position& point) {
  return {rounded(point.x(), kPositionSteps), rounded(point.y(), kPositionSteps)};
}

}  // namespace

ReadingStore::ReadingStore(const Config::Map& config, const std::vector<AccessPoint>& access_points)
    : config_(config),
      extent_(config, access_points),
      is_open_(access_points.empty()),
      table_(makeTable(access_points)) {}

std::shared_ptr<const ReadingStore::Table> ReadingStore::makeTable(
    const std::vector<AccessPoint>& access_points) {
  Table table{access_points, {}};
  for (std::size_t i = 0; i < access_points.size(); ++i) {
    if (!table.index_of.emplace(access_points[i].bssid, i).second) {
      throw InputError("access_points holds " + access_points[i].bssid.str() + " twice");
    }
  }
  return std::make_shared<const Table>(std::move(table));
}

InsertResult ReadingStore::makeRoomFor(const Position& point) {
  return extent_.makeRoomFor(point, [this] { return extent(); });
}

bool ReadingStore::isInTable(const Bssid& bssid) {
  constexpr std::size_t kMostFound = 2000;
  if (table_->index_of.count(bssid) > 0) {
    return true;
  }
  std::vector<AccessPoint> access_points = table_->access_points;
  if (!is_open_ || access_points.size() >= kMostFound) {
    return false;
  }
  AccessPoint found;
  found.bssid = bssid;
  found.position_known = false;
  // In order of addresses, the map does not depend on who is heard first.
  access_points.insert(
      std::lower_bound(access_points.begin(), access_points.end(), found,
                       [](const auto& a, const auto& b) { return a.bssid < b.bssid; }),
      found);
  table_ = makeTable(access_points);
  return true;
}

void ReadingStore::reserve(std::size_t readings) {
  readings_.reserve(std::min(readings, static_cast<std::size_t>(config_.max_readings)));
}

InsertResult ReadingStore::insert(const Reading& reading) {
  const InsertResult result = accept(reading);
  remember(reading, result);
  if (result != InsertResult::kAccepted) {
    ++rejections_.count[result];
  }
  constexpr std::size_t kMostNamed = 1000;
  auto& unknown = rejections_.unknown_access_points;
  if (result == InsertResult::kUnknownAccessPoint &&
      (unknown.size() < kMostNamed || unknown.count(reading.bssid) > 0)) {
    ++unknown[reading.bssid];
  }
  return result;
}

void ReadingStore::remember(const Reading& reading, InsertResult result) {
  constexpr std::size_t kMostRefused = 100000;
  if (table_->index_of.count(reading.bssid) > 0) {
    ++heard_[reading.bssid];
  }
  const bool is_refused =
      result == InsertResult::kRssiOutOfRange || result == InsertResult::kPositionTooFar;
  if (is_refused && reading.antenna_in_map.allFinite() && refused_.size() < kMostRefused) {
    refused_.push_back(reading);
    refused_.back().rssi_dbm = rounded(reading.rssi_dbm, kRssiSteps);
  }
  std::int64_t& last_stamp_ns =
      last_stamp_ns_.emplace(reading.robot, reading.stamp_ns).first->second;
  last_stamp_ns = std::max(last_stamp_ns, reading.stamp_ns);
  step_back_ns_ = std::max(step_back_ns_, last_stamp_ns - reading.stamp_ns);
}

InsertResult ReadingStore::examine(const Reading& reading) const {
  if (!std::isfinite(reading.rssi_dbm)) {
    return InsertResult::kRssiNotFinite;
  }
  if (!isInRssiRange(reading.rssi_dbm)) {
    return InsertResult::kRssiOutOfRange;
  }
  return readings_.size() < static_cast<std::size_t>(config_.max_readings)
             ? InsertResult::kAccepted
             : InsertResult::kTooManyReadings;
}

InsertResult ReadingStore::accept(const Reading& reading) {
  const bool is_in_table = isInTable(reading.bssid);
  const InsertResult examined = examine(reading);
  if (examined != InsertResult::kAccepted) {
    return examined;
  }
  const Reading kept{reading.stamp_ns, rounded(reading.antenna_in_map), reading.bssid,
                     rounded(reading.rssi_dbm, kRssiSteps), reading.robot};
  const InsertResult room = makeRoomFor(kept.antenna_in_map);
  if (room != InsertResult::kAccepted) {
    return room;
  }
  readings_.push_back(kept);
  return is_in_table ? InsertResult::kAccepted : InsertResult::kUnknownAccessPoint;
}

InsertResult ReadingStore::insert(const Contact& contact) {
  const Position point = rounded(contact.point_in_map);
  const bool full = contacts_.size() >= static_cast<std::size_t>(config_.max_readings);
  const InsertResult result = full ? InsertResult::kTooManyReadings : makeRoomFor(point);
  if (result == InsertResult::kAccepted) {
    contacts_.push_back({contact.stamp_ns, point, contact.robot});
  } else {
    ++rejections_.count[result];
  }
  return result;
}

InsertResult ReadingStore::insertPose(std::int64_t stamp_ns, const Position& antenna_in_map,
                                      const std::string& robot) {
  const Position position = rounded(antenna_in_map);
  const bool full = poses_.size() >= static_cast<std::size_t>(config_.max_readings);
  const InsertResult result = full ? InsertResult::kTooManyReadings : makeRoomFor(position);
  if (result == InsertResult::kAccepted) {
    poses_.push_back({stamp_ns, position, PathPose::kNoWallCount, robot});
  }
  return result;
}

void ReadingStore::recordRejected(const std::string& reason, std::size_t count) {
  rejections_.before_insertion[reason] += count;
}

void ReadingStore::correct(
    const std::function<Position(std::int64_t, const Position&, const std::string&)>& moved) {
  for (Reading& reading : readings_) {
    reading.antenna_in_map =
        rounded(moved(reading.stamp_ns, reading.antenna_in_map, reading.robot));
  }
  for (Contact& contact : contacts_) {
    contact.point_in_map = rounded(moved(contact.stamp_ns, contact.point_in_map, contact.robot));
  }
  for (PathPose& pose : poses_) {
    pose.antenna_in_map = rounded(moved(pose.stamp_ns, pose.antenna_in_map, pose.robot));
  }
  if (!reserveAll()) {
    dropWhatDoesNotFit();
  }
}

bool ReadingStore::reserveAll() {
  Box all;
  bool finite = true;
  const auto include = [&](const Position& point) {
    finite = finite && point.allFinite();
    all.extend(point);
  };
  for (const Reading& reading : readings_) {
    include(reading.antenna_in_map);
  }
  for (const Contact& contact : contacts_) {
    include(contact.point_in_map);
  }
  for (const PathPose& pose : poses_) {
    include(pose.antenna_in_map);
  }
  return finite && extent_.reserveMoved(all);
}

void ReadingStore::dropWhatDoesNotFit() {
  const auto filter = [&](auto&& examineOne) {
    const auto drops = [&](const Position& point) {
      const InsertResult result = examineOne(point);
      if (result != InsertResult::kAccepted) {
        ++rejections_.count[result];
      }
      return result != InsertResult::kAccepted;
    };
    eraseIf(readings_, [&](const Reading& one) { return drops(one.antenna_in_map); });
    eraseIf(contacts_, [&](const Contact& one) { return drops(one.point_in_map); });
    eraseIf(poses_, [&](const PathPose& one) {
      return examineOne(one.antenna_in_map) != InsertResult::kAccepted;
    });
  };
  filter([](const Position& point) {
    return point.allFinite() ? InsertResult::kAccepted : InsertResult::kPositionNotFinite;
  });
  // Stray poses are found on the whole corrected path, before any reading is dropped.
  extent_.release(extent());
  filter([&](const Position& point) { return extent_.reserve(point); });
}

void ReadingStore::reset() {
  extent_.restart(extent());
  readings_.clear();
  contacts_.clear();
  poses_.clear();
  rejections_ = {};
  refused_.clear();
  heard_.clear();
  if (is_open_) {
    std::vector<AccessPoint> placed = table_->access_points;
    eraseIf(placed, [](const AccessPoint& one) { return !one.position_known; });
    table_ = makeTable(placed);
  }
  last_stamp_ns_.clear();
  step_back_ns_ = 0;
  frames_ = {};
}

void ReadingStore::drop() {
  readings_ = std::vector<Reading>();  // `= {}` would keep their memory
  contacts_ = std::vector<Contact>();
  poses_ = std::vector<PathPose>();
}

std::pair<std::size_t, std::size_t> ReadingStore::forget(
    const std::function<bool(std::int64_t, const Position&, const std::string&)>& test) {
  extent_.growTo(extent());
  const std::size_t readings = readings_.size();
  const std::size_t contacts = contacts_.size();
  eraseIf(readings_,
          [&](const Reading& one) { return test(one.stamp_ns, one.antenna_in_map, one.robot); });
  eraseIf(contacts_,
          [&](const Contact& one) { return test(one.stamp_ns, one.point_in_map, one.robot); });
  eraseIf(poses_,
          [&](const PathPose& one) { return test(one.stamp_ns, one.antenna_in_map, one.robot); });
  return {readings - readings_.size(), contacts - contacts_.size()};
}

void ReadingStore::setAccessPoints(std::vector<AccessPoint> access_points) {
  if (is_open_) {
    std::sort(access_points.begin(), access_points.end(),
              [](const auto& a, const auto& b) { return a.bssid < b.bssid; });
  }
  std::shared_ptr<const Table> table = makeTable(access_points);
  extent_.extendTo(access_points);
  table_ = std::move(table);
}

std::vector<std::size_t> ReadingStore::heard() const {
  std::vector<std::size_t> heard;
  for (const AccessPoint& access_point : table_->access_points) {
    const auto found = heard_.find(access_point.bssid);
    heard.push_back(found == heard_.end() ? 0 : found->second);
  }
  return heard;
}

std::vector<Reading> ReadingStore::readings() const {
  return strongestOfEachStamp(sortedByStamp(readings_));
}

std::vector<PathPose> ReadingStore::poses() const { return sortedPath(poses_); }

RecordingData ReadingStore::data() const {
  return {sortedByStamp(readings_), sortedByStamp(refused_), step_back_ns_};
}

InlierReadings ReadingStore::inliers(const ReadingRefs& sorted) const {
  return readingsWithoutStrayPoses(sorted, contacts_, poses_);
}

Inliers ReadingStore::withSamples(InlierReadings readings) const {
  return sfw::withSamples(std::move(readings), table_->index_of);
}

Box ReadingStore::extentOf(const Inliers& inliers) const {
  Box extent = extent_.least();
  for (const PathPose& pose : inliers.path) {
    extent.extend(pose.antenna_in_map);
  }
  for (const Contact& contact : inliers.contacts) {
    extent.extend(contact.point_in_map);
  }
  return extent;
}

}  // namespace sfw
