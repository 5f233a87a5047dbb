#include "ros/mapping/transform_intake.h"

#include <boost/function.hpp>
#include <cmath>
#include <utility>

namespace sfw {
namespace {

bool isInfinite(const geometry_msgs::Transform& transform) {
  const geometry_msgs::Vector3& v = transform.translation;
  const geometry_msgs::Quaternion& q = transform.rotation;
  return std::isinf(v.x) || std::isinf(v.y) || std::isinf(v.z) || std::isinf(q.x) ||
         std::isinf(q.y) || std::isinf(q.z) || std::isinf(q.w);
}

}  // namespace

bool takeTransform(const geometry_msgs::TransformStamped& transform, const std::string& publisher,
                   bool is_static, tf2::BufferCore& transforms, TransformWatch& watch) {
  if (isInfinite(transform.transform)) {
    return false;
  }
  // tf2 ignores a transform whose stamp it has, and prints two lines for each one.
  if (watch.observe(transform, publisher) || is_static) {
    transforms.setTransform(transform, publisher, is_static);  // tells itself what it refuses
  }
  return true;
}

TransformIntake::TransformIntake(ros::NodeHandle& node, tf2::BufferCore& transforms,
                                 TransformWatch& watch, OnFailure on_failure)
    : transforms_(transforms), watch_(watch), on_failure_(std::move(on_failure)) {
  constexpr std::uint32_t kQueue = 1000;
  using Event = ros::MessageEvent<tf2_msgs::TFMessage const>;
  const auto subscribeTo = [&](const char* topic, bool is_static) {
    const boost::function<void(const Event&)> callback = [this, is_static](const Event& event) {
      try {
        take(event, is_static);
      } catch (const std::exception& error) {
        // An exception that leaves a callback ends the nodelet manager.
        on_failure_(error);
      }
    };
    return node.subscribe<tf2_msgs::TFMessage>(topic, kQueue, callback);
  };
  moving_ = subscribeTo("/tf", false);
  static_ = subscribeTo("/tf_static", true);
}

void TransformIntake::take(const ros::MessageEvent<tf2_msgs::TFMessage const>& event,
                           bool is_static) {
  const ros::Time now = ros::Time::now();
  if (now < last_now_) {
    transforms_.clear();
    watch_.clear();
  }
  last_now_ = now;
  for (const geometry_msgs::TransformStamped& transform : event.getConstMessage()->transforms) {
    if (!takeTransform(transform, event.getPublisherName(), is_static, transforms_, watch_)) {
      ++left_out_;
    }
  }
}

}  // namespace sfw
