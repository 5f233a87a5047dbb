#include "mapping/reading_store.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/erase_if.h"
#include "base/map_too_large.h"
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

Box withMargin(const Box& extent, double margin_m) {
  const Position margin(margin_m, margin_m);
  return {extent.min() - margin, extent.max() + margin};
}

GridGeometry geometryAround(const Box& extent, const Config::Map& config) {
  return GridGeometry::covering(withMargin(extent, config.margin_m), config.resolution_m,
                                config.growth_step_m, config.max_cells);
}

Box extentOf(const std::vector<AccessPoint>& access_points) {
  Box box;
  for (const AccessPoint& access_point : access_points) {
    if (access_point.position_known) {
      box.extend(access_point.position);
    }
  }
  if (box.isEmpty()) {
    box.extend(Position::Zero());  // a map needs a position before the first reading
  }
  return box;
}

/// The extent of a map without readings.
/// @throw InputError if the table is empty, or no map can hold its positions.
Box leastExtent(const Config::Map& config, const std::vector<AccessPoint>& access_points) {
  if (access_points.empty()) {
    throw InputError("access_points must hold at least one access point");
  }
  for (const AccessPoint& access_point : access_points) {
    if (!access_point.position.allFinite()) {
      throw InputError("access_points: the position of " + access_point.bssid.str() +
                       " must be finite");
    }
  }
  const Box extent = extentOf(access_points);
  try {
    geometryAround(extent, config);
  } catch (const std::invalid_argument& error) {
    throw InputError("no map can hold the access points: " + std::string(error.what()) +
                     "; correct their positions, or raise map/max_cells (" +
                     std::to_string(config.max_cells) +
                     "), raise map/resolution, or lower map/growth_step");
  }
  return extent;
}

}  // namespace

const char* toString(InsertResult result) {
  switch (result) {
    case InsertResult::kAccepted:
      return "accepted";
    case InsertResult::kPositionNotFinite:
      return "position is not finite";
    case InsertResult::kPositionTooFar:
      return "position is so far away that the map would exceed map/max_cells";
    case InsertResult::kRssiNotFinite:
      return "rssi_dbm is not finite";
    case InsertResult::kRssiOutOfRange:
      return "rssi_dbm is not in (-120, 0] (a percentage, or an inaudible radio?)";
    case InsertResult::kUnknownAccessPoint:
      return "bssid is not in the table of access points";
    case InsertResult::kTooManyReadings:
      return "map/max_readings is reached";
  }
  return "";
}

ReadingStore::ReadingStore(const Config::Map& config, const std::vector<AccessPoint>& access_points)
    : config_(config),
      least_extent_(leastExtent(config, access_points)),
      reserved_extent_(least_extent_) {
  table_ = makeTable(access_points);
  heard_.assign(access_points.size(), 0);
}

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

bool ReadingStore::fits(const Box& extent) const {
  return GridGeometry::canCover(withMargin(extent, config_.margin_m), config_.resolution_m,
                                config_.growth_step_m, config_.max_cells);
}

InsertResult ReadingStore::reserve(const Position& point) {
  if (!point.allFinite()) {
    return InsertResult::kPositionNotFinite;
  }
  if (!reserved_extent_.contains(point)) {
    const Box extent = reserved_extent_.merged(Box(point));
    if (!fits(extent)) {
      return InsertResult::kPositionTooFar;
    }
    reserved_extent_ = extent;
  }
  return InsertResult::kAccepted;
}

InsertResult ReadingStore::makeRoomFor(const Position& point) {
  InsertResult result = reserve(point);
  if (result == InsertResult::kPositionTooFar && holds_stray_room_) {
    reserved_extent_ = extentOf(inliers());
    holds_stray_room_ = false;
    result = reserve(point);
  }
  // The point may be stray itself, or make other poses stray.
  holds_stray_room_ = holds_stray_room_ || result == InsertResult::kAccepted;
  return result;
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
  const auto found = table_->index_of.find(reading.bssid);
  if (found != table_->index_of.end()) {
    ++heard_[found->second];
  }
  const bool is_refused =
      result == InsertResult::kRssiOutOfRange || result == InsertResult::kPositionTooFar;
  if (is_refused && reading.antenna_in_map.allFinite() && refused_.size() < kMostRefused) {
    refused_.push_back(reading);
    refused_.back().rssi_dbm = rounded(reading.rssi_dbm, kRssiSteps);
  }
  last_stamp_ns_ = std::max(last_stamp_ns_.value_or(reading.stamp_ns), reading.stamp_ns);
  step_back_ns_ = std::max(step_back_ns_, *last_stamp_ns_ - reading.stamp_ns);
}

InsertResult ReadingStore::examine(const Reading& reading) const {
  if (!std::isfinite(reading.rssi_dbm)) {
    return InsertResult::kRssiNotFinite;
  }
  if (reading.rssi_dbm <= -120.0 || reading.rssi_dbm > 0.0) {
    return InsertResult::kRssiOutOfRange;
  }
  return readings_.size() < static_cast<std::size_t>(config_.max_readings)
             ? InsertResult::kAccepted
             : InsertResult::kTooManyReadings;
}

InsertResult ReadingStore::accept(const Reading& reading) {
  const InsertResult examined = examine(reading);
  if (examined != InsertResult::kAccepted) {
    return examined;
  }
  const Reading kept{reading.stamp_ns, rounded(reading.antenna_in_map), reading.bssid,
                     rounded(reading.rssi_dbm, kRssiSteps)};
  const InsertResult room = makeRoomFor(kept.antenna_in_map);
  if (room != InsertResult::kAccepted) {
    return room;
  }
  readings_.push_back(kept);
  return table_->index_of.count(kept.bssid) > 0 ? InsertResult::kAccepted
                                                : InsertResult::kUnknownAccessPoint;
}

InsertResult ReadingStore::insert(const Contact& contact) {
  const Position point = rounded(contact.point_in_map);
  const bool full = contacts_.size() >= static_cast<std::size_t>(config_.max_readings);
  const InsertResult result = full ? InsertResult::kTooManyReadings : makeRoomFor(point);
  if (result == InsertResult::kAccepted) {
    contacts_.push_back({contact.stamp_ns, point});
  } else {
    ++rejections_.count[result];
  }
  return result;
}

void ReadingStore::recordRejected(const std::string& reason, std::size_t count) {
  rejections_.before_insertion[reason] += count;
}

void ReadingStore::correct(const PathCorrection& correction) {
  if (correction.empty()) {
    return;
  }
  for (Reading& reading : readings_) {
    reading.antenna_in_map = rounded(correction.moved(reading.stamp_ns, reading.antenna_in_map));
  }
  for (Contact& contact : contacts_) {
    contact.point_in_map = rounded(correction.moved(contact.stamp_ns, contact.point_in_map));
  }
  if (!reserveAll()) {
    dropWhatDoesNotFit();
  }
  holds_stray_room_ = true;
}

bool ReadingStore::reserveAll() {
  Box extent = reserved_extent_;
  bool finite = true;
  const auto include = [&](const Position& point) {
    finite = finite && point.allFinite();
    extent.extend(point);
  };
  for (const Reading& reading : readings_) {
    include(reading.antenna_in_map);
  }
  for (const Contact& contact : contacts_) {
    include(contact.point_in_map);
  }
  if (!finite || !fits(extent)) {
    return false;
  }
  reserved_extent_ = extent;
  return true;
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
  };
  filter([](const Position& point) {
    return point.allFinite() ? InsertResult::kAccepted : InsertResult::kPositionNotFinite;
  });
  // Stray poses are found on the whole corrected path, before any reading is dropped.
  const Box extent = extentOf(inliers());
  reserved_extent_ = fits(extent) ? extent : least_extent_;
  filter([&](const Position& point) { return reserve(point); });
}

void ReadingStore::growTo(const Box& extent) {
  if (fits(reserved_extent_.merged(extent))) {
    least_extent_.extend(extent);
    reserved_extent_.extend(extent);
  }
}

void ReadingStore::reset() {
  least_extent_ = extentOf(inliers());
  reserved_extent_ = least_extent_;
  holds_stray_room_ = false;
  readings_.clear();
  contacts_.clear();
  rejections_ = {};
  refused_.clear();
  heard_.assign(heard_.size(), 0);
  last_stamp_ns_.reset();
  step_back_ns_ = 0;
  frames_ = {};
}

std::pair<std::size_t, std::size_t> ReadingStore::forget(
    const std::function<bool(std::int64_t, const Position&)>& test) {
  growTo(extentOf(inliers()));
  const std::size_t readings = readings_.size();
  const std::size_t contacts = contacts_.size();
  eraseIf(readings_, [&](const Reading& one) { return test(one.stamp_ns, one.antenna_in_map); });
  eraseIf(contacts_, [&](const Contact& one) { return test(one.stamp_ns, one.point_in_map); });
  return {readings - readings_.size(), contacts - contacts_.size()};
}

void ReadingStore::setAccessPoints(const std::vector<AccessPoint>& access_points) {
  std::shared_ptr<const Table> table = makeTable(access_points);
  const Box extent = leastExtent(config_, access_points).merged(reserved_extent_);
  if (!fits(extent)) {
    throw InputError("no map can hold the access points and the path: " +
                     tooLargeText(extent, config_));
  }
  std::vector<std::size_t> heard(access_points.size(), 0);
  for (std::size_t i = 0; i < heard.size(); ++i) {
    const auto before = table_->index_of.find(access_points[i].bssid);
    heard[i] = before == table_->index_of.end() ? 0 : heard_[before->second];
  }
  heard_ = std::move(heard);
  table_ = std::move(table);
  least_extent_.extend(leastExtent(config_, access_points));
  reserved_extent_ = extent;
}

std::vector<Reading> ReadingStore::readings() const {
  return strongestOfEachStamp(sortedByStamp(readings_));
}

RecordingData ReadingStore::data() const {
  return {sortedByStamp(readings_), sortedByStamp(refused_), step_back_ns_};
}

Inliers ReadingStore::inliers(std::vector<Reading> sorted) const {
  return withoutStrayPoses(std::move(sorted), contacts_, table_->index_of);
}

Box ReadingStore::extentOf(const Inliers& inliers) const {
  Box extent = least_extent_;
  for (const PathPose& pose : inliers.path) {
    extent.extend(pose.antenna_in_map);
  }
  for (const Contact& contact : inliers.contacts) {
    extent.extend(contact.point_in_map);
  }
  return extent;
}

GridGeometry ReadingStore::geometryOf(const Box& extent) const {
  try {
    return geometryAround(extent, config_);
  } catch (const std::invalid_argument&) {
    throw InputError(tooLargeText(extent, config_));
  }
}

}  // namespace sfw
