#include "ros/mapping/transform_watch.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "ros/mapping/localization.h"

namespace sfw {

bool TransformWatch::Place::isFar(const Place& other) const {
  constexpr double kFar = 0.1;    // [m]
  constexpr double kTurn = 0.05;  // [rad]
  return parent != other.parent || (position - other.position).norm() > kFar ||
         std::abs(std::remainder(yaw_rad - other.yaw_rad, 2.0 * kPi)) > kTurn;
}

bool TransformWatch::observe(const geometry_msgs::TransformStamped& transform,
                             const std::string& publisher) {
  constexpr std::size_t kMostFrames = 10000;
  constexpr std::size_t kMostPublishers = 10;
  const geometry_msgs::Vector3& translation = transform.transform.translation;
  const Place place{withoutSlash(transform.header.frame_id),
                    {translation.x, translation.y},
                    yawOf(transform.transform.rotation)};
  const std::string frame = withoutSlash(transform.child_frame_id);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (links_.size() >= kMostFrames && links_.count(frame) == 0) {
    return true;
  }
  Link& link = links_[frame];
  const ros::Time stamp = transform.header.stamp;
  const auto* const end = link.recent.begin() + std::min(link.messages, link.recent.size());
  const auto* const known =
      std::find_if(link.recent.cbegin(), end, [&](const auto& one) { return one.first == stamp; });
  if (known != end && !place.isFar(known->second)) {
    return false;  // the same message again, perhaps late: it is no second publisher
  }
  const bool is_new = known == end;
  link.recent[link.messages % link.recent.size()] = {stamp, place};
  if (link.messages++ > 0 && place.isFar(link.last)) {
    link.flips += link.before_jump && !place.isFar(*link.before_jump) ? 1 : 0;
    link.before_jump = link.last;
  }
  link.last = place;
  if (!publisher.empty() && link.publishers.size() < kMostPublishers) {
    link.publishers.insert(publisher);
  }
  return is_new;
}

void TransformWatch::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  links_.clear();
}

bool TransformWatch::hasTwoPublishers(const Link& link) {
  constexpr std::size_t kFewest = 10;
  constexpr std::size_t kShare = 20;  // a localisation that errs jumps far more seldom
  return link.flips >= kFewest && kShare * link.flips >= link.messages;
}

FrameFinding TransformWatch::finding(const std::string& antenna_frame) const {
  constexpr int kMostFrames = 100;  // a loop of frames must not hang
  const std::lock_guard<std::mutex> lock(mutex_);
  FrameFinding finding;
  std::string frame = antenna_frame;
  for (int i = 0; i < kMostFrames; ++i) {
    const auto found = links_.find(frame);
    if (found == links_.end()) {
      return finding;
    }
    const Link& link = found->second;
    if (hasTwoPublishers(link)) {
      finding.published_twice = link.last.parent + " to " + frame;
      finding.flips = link.flips;
      std::string names;
      for (const std::string& name : link.publishers) {
        names += (names.empty() ? "" : ", ") + name;
      }
      finding.published_twice += link.publishers.size() > 1 ? " (by " + names + ")" : "";
      return finding;
    }
    frame = link.last.parent;
  }
  return finding;
}

}  // namespace sfw
