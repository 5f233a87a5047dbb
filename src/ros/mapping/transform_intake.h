#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>

#include "ros/mapping/transform_watch.h"

namespace sfw {

/// Gives a transform to tf's buffer and to the watch.
///
/// One that is not finite is left out. tf2 0.7 refuses those that are no number but takes infinite
/// ones, and then no pose between their neighbours is finite
/// (findings/tf2_takes_infinite_transforms.sh). One that repeats an earlier one is no fault.
/// @param publisher  the name of its node, if it is known
/// @return false if it was left out
bool takeTransform(const geometry_msgs::TransformStamped& transform, const std::string& publisher,
                   bool is_static, tf2::BufferCore& transforms, TransformWatch& watch);

/// Takes the transforms of /tf and /tf_static. When the clock jumps back, it forgets those of
/// before, as tf2_ros::TransformListener does.
class TransformIntake {
 public:
  using OnFailure = std::function<void(const std::exception&)>;

  /// Takes transforms in the callbacks of a node; buffer and watch must live as long.
  /// @param on_failure  told why a message was left out, in the callback; must not throw
  TransformIntake(ros::NodeHandle& node, tf2::BufferCore& transforms, TransformWatch& watch,
                  OnFailure on_failure);

  /// The number of transforms that were not finite.
  std::size_t leftOut() const { return left_out_; }

 private:
  void take(const ros::MessageEvent<tf2_msgs::TFMessage const>& event, bool is_static);

  tf2::BufferCore& transforms_;
  TransformWatch& watch_;
  const OnFailure on_failure_;
  ros::Time last_now_;  // in the callbacks only
  std::atomic<std::size_t> left_out_{0};
  ros::Subscriber moving_, static_;  // last, so that no callback finds the others gone
};

}  // namespace sfw
