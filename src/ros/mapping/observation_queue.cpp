#include "ros/mapping/observation_queue.h"

#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

Eigen::Vector3d toVector(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Quaterniond toQuaternion(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

double yawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

/// Where antenna and odometry were at a time, if tf knows both.
std::optional<OdometryCorrection> fixAt(const ros::Time& stamp, const Config::Ros& config,
                                        const tf2::BufferCore& transforms) {
  if (config.odom_frame == config.map_frame || stamp.isZero() ||
      !transforms.canTransform(config.map_frame, config.odom_frame, stamp) ||
      !transforms.canTransform(config.map_frame, config.antenna_frame, stamp)) {
    return std::nullopt;
  }
  const auto mapFrom = [&](const std::string& frame) {
    return transforms.lookupTransform(config.map_frame, frame, stamp).transform;
  };
  const geometry_msgs::Transform map_from_odom = mapFrom(config.odom_frame);
  return OdometryCorrection{static_cast<std::int64_t>(stamp.toNSec()),
                            toVector(mapFrom(config.antenna_frame).translation).head<2>(),
                            toVector(map_from_odom.translation).head<2>(),
                            yawOf(map_from_odom.rotation)};
}

PlacedObservation placed(const Observation& observation, const Eigen::Vector3d& sensor_in_map,
                         const Eigen::Quaterniond& turn) {
  const auto stamp_ns = static_cast<std::int64_t>(observation.stamp.toNSec());
  if (const auto* reading = std::get_if<UnplacedReading>(&observation.content)) {
    return {Reading{stamp_ns, sensor_in_map.head<2>(), reading->bssid, reading->rssi_dbm}, {}};
  }
  std::vector<Contact> contacts;
  for (const Eigen::Vector3d& point : std::get<UnplacedContacts>(observation.content).points) {
    const Eigen::Vector3d in_map = turn * point + sensor_in_map;
    contacts.push_back({stamp_ns, in_map.head<2>()});
  }
  return {std::move(contacts), {}};
}

}  // namespace

std::optional<PlacedObservation> place(const Observation& observation, const Config::Ros& config,
                                       const tf2::BufferCore& transforms, std::string& reason) {
  const auto* contacts = std::get_if<UnplacedContacts>(&observation.content);
  const std::string& frame = contacts != nullptr ? contacts->frame : config.antenna_frame;
  try {
    const geometry_msgs::Transform map_from_sensor =
        transforms.lookupTransform(config.map_frame, frame, observation.stamp).transform;
    PlacedObservation result = placed(observation, toVector(map_from_sensor.translation),
                                      toQuaternion(map_from_sensor.rotation));
    result.fix = fixAt(observation.stamp, config, transforms);
    return result;
  } catch (const std::exception& error) {
    // Not only tf2's own: it subtracts stamps, and ros::Duration throws if they lie 68 years apart.
    reason = error.what();
    return std::nullopt;
  }
}

std::optional<OdometryCorrection> latestFix(const Config::Ros& config,
                                            const tf2::BufferCore& transforms) {
  try {
    if (!transforms.canTransform(config.map_frame, config.antenna_frame, ros::Time())) {
      return std::nullopt;
    }
    const ros::Time latest =
        transforms.lookupTransform(config.map_frame, config.antenna_frame, ros::Time())
            .header.stamp;
    return fixAt(latest, config, transforms);
  } catch (const std::exception&) {
    return std::nullopt;  // the buffer changed between two look-ups
  }
}

void insert(const PlacedObservation& observation, Mapper& mapper, PathCorrector& anchor) {
  const auto isKept = [](InsertResult insertion) {
    return insertion == InsertResult::kAccepted || insertion == InsertResult::kUnknownAccessPoint;
  };
  bool kept = false;
  if (const auto* reading = std::get_if<Reading>(&observation.content)) {
    kept = isKept(mapper.insert(*reading));
  } else {
    for (const Contact& contact : std::get<std::vector<Contact>>(observation.content)) {
      kept = isKept(mapper.insert(contact)) || kept;
    }
  }
  if (kept && observation.fix) {
    anchor.insert(*observation.fix);
  }
}

PathCorrector::Tolerance jumpTolerance(const Config::Ros& config) {
  return {config.jump_distance_m, config.jump_angle_rad};
}

void ObservationQueue::push(Observation observation) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_.size() >= static_cast<std::size_t>(config_.max_waiting)) {
    waiting_.pop_front();
    ++crowded_out_;
  }
  waiting_.push_back({std::move(observation), ros::Time()});
}

void ObservationQueue::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.clear();
}

bool ObservationQueue::isExpired(const Waiting& waiting, const ros::Time& now) const {
  // Not by ros::Duration: it throws where stamps lie 68 years apart.
  const auto is_long_before_now = [&](const ros::Time& time) {
    return now.toSec() - time.toSec() > config_.transform_timeout_s;
  };
  return is_long_before_now(waiting.observation.stamp) ||
         (!waiting.since.isZero() && is_long_before_now(waiting.since));
}

ObservationQueue::Outcome ObservationQueue::place(const tf2::BufferCore& transforms,
                                                  const ros::Time& now, const Sink& sink) {
  std::deque<Waiting> all;
  Outcome outcome;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    all.swap(waiting_);
    std::swap(outcome.crowded_out, crowded_out_);
  }
  std::deque<Waiting> still_waiting;
  for (Waiting& waiting : all) {
    std::string reason;
    if (const auto placed = sfw::place(waiting.observation, config_, transforms, reason)) {
      sink(*placed);
      ++outcome.placed;
    } else if (isExpired(waiting, now)) {
      ++outcome.expired;
      outcome.reason = reason;
    } else {
      waiting.since = waiting.since.isZero() ? now : waiting.since;
      still_waiting.push_back(std::move(waiting));
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  waiting_.insert(waiting_.begin(), std::make_move_iterator(still_waiting.begin()),
                  std::make_move_iterator(still_waiting.end()));
  return outcome;
}

}  // namespace sfw
