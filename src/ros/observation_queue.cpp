#include "observation_queue.h"

#include <algorithm>

namespace sfw {
namespace {

Eigen::Vector3d toVector(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Quaterniond toQuaternion(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z);
}

}  // namespace

bool place(const Observation& observation, const Config::Ros& config,
           const tf2::BufferCore& transforms, Mapper& mapper, std::string& reason) {
  const auto* reading = std::get_if<UnplacedReading>(&observation.content);
  const auto* contacts = std::get_if<UnplacedContacts>(&observation.content);
  const std::string& frame = reading != nullptr ? config.antenna_frame : contacts->frame;
  geometry_msgs::Transform map_from_sensor;
  try {
    map_from_sensor =
        transforms.lookupTransform(config.map_frame, frame, observation.stamp).transform;
  } catch (const std::exception& error) {
    // Not only tf2's own: it subtracts stamps, and ros::Duration throws if they lie 68 years apart.
    reason = error.what();
    return false;
  }
  const auto stamp_ns = static_cast<std::int64_t>(observation.stamp.toNSec());
  const Eigen::Vector3d origin = toVector(map_from_sensor.translation);
  if (reading != nullptr) {
    mapper.insert(Reading{stamp_ns, origin.head<2>(), reading->bssid, reading->rssi_dbm});
    return true;
  }
  for (const Eigen::Vector3d& point : contacts->points) {
    const Eigen::Vector3d in_map = toQuaternion(map_from_sensor.rotation) * point + origin;
    mapper.insert(Contact{stamp_ns, in_map.head<2>()});
  }
  return true;
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
    return now.toSec() - time.toSec() > config_.transform_timeout;
  };
  return is_long_before_now(waiting.observation.stamp) ||
         (!waiting.since.isZero() && is_long_before_now(waiting.since));
}

ObservationQueue::Outcome ObservationQueue::place(const tf2::BufferCore& transforms,
                                                  const ros::Time& now, Mapper& mapper) {
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
    if (sfw::place(waiting.observation, config_, transforms, mapper, reason)) {
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
