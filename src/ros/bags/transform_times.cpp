#include "ros/bags/transform_times.h"

#include <cstddef>

#include "ros/conversion/ros_settings.h"

namespace sfw {
namespace {

/// Shrinks a span to its part in another one.
void intersect(TransformSpan& span, const TransformSpan& other) {
  if (other.first_stamp > span.first_stamp) {
    span.first_stamp = other.first_stamp;
    span.first_received = other.first_received;
  }
  if (other.last_stamp < span.last_stamp) {
    span.last_stamp = other.last_stamp;
    span.last_received = other.last_received;
  }
}

}  // namespace

void TransformTimes::observe(const geometry_msgs::TransformStamped& transform,
                             const ros::Time& received) {
  const ros::Time& stamp = transform.header.stamp;
  const TransformSpan one{stamp, stamp, received, received};
  const auto [found, is_new] =
      spans_.emplace(std::make_pair(withoutSlash(transform.header.frame_id),
                                    withoutSlash(transform.child_frame_id)),
                     one);
  TransformSpan& span = found->second;
  if (stamp < span.first_stamp) {
    span.first_stamp = stamp;
    span.first_received = received;
  }
  if (stamp > span.last_stamp) {
    span.last_stamp = stamp;
    span.last_received = received;
  }
}

std::optional<TransformSpan> TransformTimes::spanOf(const std::vector<std::string>& way) const {
  std::optional<TransformSpan> all;
  for (std::size_t i = 1; i < way.size(); ++i) {
    auto link = spans_.find({way[i - 1], way[i]});
    link = link == spans_.end() ? spans_.find({way[i], way[i - 1]}) : link;
    if (link == spans_.end()) {
      continue;  // it is static
    }
    if (all) {
      intersect(*all, link->second);
    } else {
      all = link->second;
    }
  }
  return all && all->first_stamp <= all->last_stamp ? all : std::nullopt;
}

}  // namespace sfw
