#include "ros/mapping/shared_mapper.h"

#include <algorithm>
#include <utility>

#include "ros/mapping/insertion.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

AccessPoint* find(std::vector<AccessPoint>& table, const Bssid& bssid) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const AccessPoint& one) { return one.bssid == bssid; });
  return found == table.end() ? nullptr : &*found;
}

template <class Item>
void insertAll(const std::vector<Item>& items, Mapper& mapper) {
  for (const Item& item : items) {
    const InsertResult result = mapper.insert(item);
    if (result != InsertResult::kAccepted && result != InsertResult::kUnknownAccessPoint) {
      throw InputError(std::string("the session does not fit: ") + toString(result));
    }
  }
}

}  // namespace

SharedMapper::SharedMapper(const Config& config, const std::vector<AccessPoint>& access_points,
                           const PathCorrector::Tolerance& tolerance)
    : mapper_(config, access_points), corrector_(tolerance) {}

std::size_t SharedMapper::insert(const LocatedObservation& observation) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t kept = sfw::insert(observation, mapper_, corrector_);
  readings_ += kept;
  return kept;
}

void SharedMapper::configure(const Config& config) {
  const std::lock_guard<std::mutex> lock(mutex_);
  mapper_.configure(config);
}

void SharedMapper::recordRejected(const std::string& reason, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  mapper_.recordRejected(reason, count);
}

void SharedMapper::recordFrames(const FrameFinding& frames) {
  const std::lock_guard<std::mutex> lock(mutex_);
  mapper_.recordFrames(frames);
}

void SharedMapper::reset() {
  const std::lock_guard<std::mutex> lock(mutex_);
  mapper_.reset();
  corrector_.clear();
  readings_ = 0;
  ++resets_;
}

Rejections SharedMapper::rejections() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return mapper_.rejections();
}

std::size_t SharedMapper::readings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return readings_;
}

std::uint64_t SharedMapper::resets() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return resets_;
}

SharedMapper::Copy SharedMapper::corrected(const std::vector<OdometryCorrection>& latest) {
  std::unique_lock<std::mutex> lock(mutex_);
  Copy copy{mapper_, resets_, false};
  PathCorrector corrector = corrector_;
  lock.unlock();
  // tf's latest corrections are not stored. They depend on the time of this call, and later maps
  // must not.
  if (corrector.size() > 0) {
    for (const OdometryCorrection& correction : latest) {
      corrector.insert(correction);
    }
  }
  const PathCorrection correction = corrector.correction();
  copy.mapper.correct(correction);
  copy.is_corrected = !correction.empty();
  return copy;
}

void SharedMapper::keepExtent(const Box& extent, const Copy& copy) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (copy.is_corrected && copy.resets == resets_) {
    mapper_.growTo(extent);
  }
}

std::size_t SharedMapper::add(const Session& session) {
  constexpr double kSamePlace = 0.01;  // [m]
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<AccessPoint> table = mapper_.accessPoints();
  std::size_t elsewhere = 0;
  for (const AccessPoint& access_point : session.access_points) {
    const AccessPoint* known = find(table, access_point.bssid);
    if (known == nullptr) {
      table.push_back(access_point);
    } else if (known->position_known && access_point.position_known &&
               (known->position - access_point.position).norm() > kSamePlace) {
      ++elsewhere;
    }
  }
  Mapper mapper = mapper_;
  mapper.setAccessPoints(table);
  insertAll(session.readings, mapper);
  insertAll(session.contacts, mapper);
  for (const PathPose& pose : session.path) {
    mapper.insertPose(pose.stamp_ns, pose.antenna_in_map, pose.robot);
  }
  mapper_ = std::move(mapper);
  readings_ += session.readings.size();
  return elsewhere;
}

void SharedMapper::place(const Bssid& bssid, const Position& position) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<AccessPoint> table = mapper_.accessPoints();
  AccessPoint* known = find(table, bssid);
  if (known == nullptr) {
    known = &table.emplace_back();
    known->bssid = bssid;
  }
  known->position = position;
  known->position_known = true;
  known->position_sd_m.reset();  // it belongs to the position before
  mapper_.setAccessPoints(table);
}

std::pair<std::size_t, std::size_t> SharedMapper::forget(
    const std::function<bool(const Position&)>& region) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const PathCorrection correction = corrector_.correction();
  const auto forgotten = mapper_.forget(
      [&](std::int64_t stamp_ns, const Position& position, const std::string& robot) {
        return region(correction.moved(stamp_ns, position, robot));
      });
  readings_ -= std::min(readings_, forgotten.first);
  return forgotten;
}

}  // namespace sfw
