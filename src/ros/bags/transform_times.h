#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sfw {

/// The first and the last transform of a recording.
struct TransformSpan {
  ros::Time first_stamp, last_stamp;
  ros::Time first_received, last_received;  ///< when these two were recorded
};

/// Tells from when to when a recording has transforms. tf2 only says that one is missing.
class TransformTimes {
 public:
  /// Takes a transform that is not static, in any order.
  void observe(const geometry_msgs::TransformStamped& transform, const ros::Time& received);

  /// The time in which the recording has all transforms on a way through the tree.
  /// @param way  neighbouring frames, as framesBetween gives them
  /// @return nothing if no transform on the way moves, or if they have no time in common.
  std::optional<TransformSpan> spanOf(const std::vector<std::string>& way) const;

 private:
  std::map<std::pair<std::string, std::string>, TransformSpan> spans_;  // by parent and child
};

}  // namespace sfw
