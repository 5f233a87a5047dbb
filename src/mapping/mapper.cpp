#include "structure_from_wifi/mapper.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/map_too_large.h"
#include "mapping/reading_order.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Below the precision of any odometry and any radio, far above that of their arithmetic.
constexpr double kPositionSteps = 1e4;  // [1/m]
constexpr double kRssiSteps = 1e2;      // [1/dB]

/// The same number that reading it back from text gives.
double rounded(double value, double steps) { return std::round(value * steps) / steps; }

Position rounded(const Position& point) {
  return {rounded(point.x(), kPositionSteps), rounded(point.y(), kPositionSteps)};
}

Box extentOf(const std::vector<AccessPoint>& access_points) {
  Box box;
  for (const AccessPoint& access_point : access_points) {
    if (access_point.position_known) {
      box.extend(access_point.position);
    }
  }
  if (box.isEmpty()) {
    box.extend(Position::Zero());  // a map must be somewhere before the first reading
  }
  return box;
}

GridGeometry geometryAround(const Box& extent, const Config::Map& config) {
  const Position margin(config.margin_m, config.margin_m);
  return GridGeometry::covering({extent.min() - margin, extent.max() + margin}, config.resolution_m,
                                config.growth_step_m, config.max_cells);
}

Box firstExtent(const Config& config, const std::vector<AccessPoint>& access_points) {
  std::string problems;
  for (const std::string& problem : validate(config)) {
    problems += (problems.empty() ? "" : "\n") + problem;
  }
  if (!problems.empty()) {
    throw InputError(problems);
  }
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
    geometryAround(extent, config.map);
  } catch (const std::invalid_argument& error) {
    throw InputError("no map can be made around the access points: " + std::string(error.what()) +
                     "; correct their positions, or raise map/max_cells (" +
                     std::to_string(config.map.max_cells) +
                     "), raise map/resolution, or lower map/growth_step");
  }
  return extent;
}

}  // namespace

const char* toString(InsertResult insertion) {
  switch (insertion) {
    case InsertResult::kAccepted:
      return "accepted";
    case InsertResult::kPositionNotFinite:
      return "position is not finite";
    case InsertResult::kPositionTooFar:
      return "position is so far out that the map would pass map/max_cells";
    case InsertResult::kRssiNotFinite:
      return "rssi_dbm is not finite";
    case InsertResult::kRssiOutOfRange:
      return "rssi_dbm is not in (-120, 0] (percent, or a driver's \"not heard\"?)";
    case InsertResult::kUnknownAccessPoint:
      return "bssid is not in the table of access points";
    case InsertResult::kTooManyReadings:
      return "map/max_readings is reached";
  }
  return "";
}

Mapper::Mapper(const Config& config, const std::vector<AccessPoint>& access_points)
    : config_(config),
      model_(configuredBeliefModel(config.belief)),
      access_points_(access_points),
      least_extent_(firstExtent(config, access_points)),
      extent_(least_extent_) {
  for (std::size_t i = 0; i < access_points_.size(); ++i) {
    if (!index_of_.emplace(access_points_[i].bssid, i).second) {
      throw InputError("access_points holds " + access_points_[i].bssid.str() + " twice");
    }
  }
}

bool Mapper::fits(const Box& extent) const {
  try {
    geometryAround(extent, config_.map);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

InsertResult Mapper::makeRoomFor(const Position& point) {
  if (!point.allFinite()) {
    return InsertResult::kPositionNotFinite;
  }
  if (extent_.contains(point)) {
    return InsertResult::kAccepted;
  }
  const Box box(point);
  const std::size_t kept = readings_.size() + contacts_.size();
  if (!fits(extent_.merged(box)) && kept_when_believed_ != kept) {
    // A stray pose must not take the room of those that are right.
    extent_ = extent();
    kept_when_believed_ = kept;
  }
  if (!fits(extent_.merged(box))) {
    return InsertResult::kPositionTooFar;
  }
  extent_.extend(point);
  return InsertResult::kAccepted;
}

InsertResult Mapper::insert(const Reading& reading) {
  const InsertResult insertion = accept(reading);
  if (insertion != InsertResult::kAccepted) {
    ++rejections_.count[insertion];
  }
  constexpr std::size_t kMostNamed = 1000;
  auto& unknown = rejections_.unknown_access_points;
  if (insertion == InsertResult::kUnknownAccessPoint &&
      (unknown.size() < kMostNamed || unknown.count(reading.bssid) > 0)) {
    ++unknown[reading.bssid];
  }
  return insertion;
}

InsertResult Mapper::examined(const Reading& reading) const {
  if (!std::isfinite(reading.rssi_dbm)) {
    return InsertResult::kRssiNotFinite;
  }
  if (reading.rssi_dbm <= -120.0 || reading.rssi_dbm > 0.0) {
    return InsertResult::kRssiOutOfRange;
  }
  const auto limit = static_cast<std::size_t>(config_.map.max_readings);
  if (readings_.size() >= limit) {
    return InsertResult::kTooManyReadings;
  }
  return InsertResult::kAccepted;
}

InsertResult Mapper::accept(const Reading& reading) {
  const InsertResult examination = examined(reading);
  if (examination != InsertResult::kAccepted) {
    return examination;
  }
  const Reading kept{reading.stamp_ns, rounded(reading.antenna_in_map), reading.bssid,
                     rounded(reading.rssi_dbm, kRssiSteps)};
  const InsertResult room = makeRoomFor(kept.antenna_in_map);
  if (room != InsertResult::kAccepted) {
    return room;
  }
  readings_.push_back(kept);
  return index_of_.count(kept.bssid) > 0 ? InsertResult::kAccepted
                                         : InsertResult::kUnknownAccessPoint;
}

InsertResult Mapper::insert(const Contact& contact) {
  const Position point = rounded(contact.point_in_map);
  const bool full = contacts_.size() >= static_cast<std::size_t>(config_.map.max_readings);
  const InsertResult insertion = full ? InsertResult::kTooManyReadings : makeRoomFor(point);
  if (insertion == InsertResult::kAccepted) {
    contacts_.push_back({contact.stamp_ns, point});
  } else {
    ++rejections_.count[insertion];
  }
  return insertion;
}

void Mapper::correct(const PathCorrection& correction) {
  if (correction.empty()) {
    return;
  }
  const auto moveAll = [&](auto& all, auto position) {
    auto kept = all.begin();
    for (auto one : all) {
      one.*position = rounded(correction.moved(one.stamp_ns, one.*position));
      const InsertResult insertion = makeRoomFor(one.*position);
      if (insertion == InsertResult::kAccepted) {
        *kept++ = one;
      } else {
        ++rejections_.count[insertion];
      }
    }
    all.erase(kept, all.end());
  };
  moveAll(readings_, &Reading::antenna_in_map);
  moveAll(contacts_, &Contact::point_in_map);
}

Box Mapper::extent() const { return extentOf(believed()); }

Box Mapper::extentOf(const Inliers& believed) const {
  Box extent = least_extent_;
  for (const PathPose& pose : believed.path) {
    extent.extend(pose.antenna_in_map);
  }
  for (const Contact& contact : believed.contacts) {
    extent.extend(contact.point_in_map);
  }
  return extent;
}

GridGeometry Mapper::geometry() const { return geometryOf(extent()); }

GridGeometry Mapper::geometryOf(const Box& extent) const {
  try {
    return geometryAround(extent, config_.map);
  } catch (const std::invalid_argument&) {
    throw InputError(tooLargeText(extent, config_.map));
  }
}

void Mapper::growTo(const Box& extent) {
  if (fits(extent_.merged(extent))) {
    least_extent_.extend(extent);
    extent_.extend(extent);
  }
}

void Mapper::reset() {
  least_extent_ = extent();
  extent_ = least_extent_;
  readings_.clear();
  contacts_.clear();
  rejections_ = {};
}

std::vector<Reading> Mapper::sorted() const {
  std::vector<Reading> readings = readings_;
  const auto full_order = [](const Reading& r) {
    return std::make_tuple(r.stamp_ns, r.bssid, -r.rssi_dbm, r.antenna_in_map.x(),
                           r.antenna_in_map.y());
  };
  std::sort(readings.begin(), readings.end(),
            [&](const Reading& a, const Reading& b) { return full_order(a) < full_order(b); });
  return readings;
}

std::vector<Reading> Mapper::readings() const { return strongestOfEachStamp(sorted()); }

}  // namespace sfw
