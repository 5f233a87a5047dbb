#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <array>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "structure_from_wifi/recording_findings.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Finds transforms that two programs publish: they go to and fro between two values.
///
/// tf shows nothing but the last value, and interpolates between both. Thread-safe.
class TransformWatch {
 public:
  /// Examines a transform, in the order of arrival.
  /// @param publisher  the name of its node, if it is known
  /// @return whether it is new; false if one of the last transforms of its frame has its stamp
  bool observe(const geometry_msgs::TransformStamped& transform, const std::string& publisher);

  /// Forgets all transforms.
  void clear();

  /// The first transform from the antenna up to the map that has two publishers. Others do not
  /// matter for a map. Call it again while transforms arrive; it is quick.
  FrameFinding finding(const std::string& antenna_frame) const;

 private:
  struct Place {
    std::string parent;
    Position position = Position::Zero();
    double yaw_rad = 0.0;

    /// Whether it differs from another one by more than a robot drives between two messages.
    bool isFar(const Place& other) const;
  };

  /// A frame in its parent.
  struct Link {
    Place last;
    std::optional<Place> before_jump;
    std::size_t messages = 0;
    std::size_t flips = 0;  // jumps that lead back to where the jump before began
    std::set<std::string> publishers;
    std::array<std::pair<ros::Time, Place>, 32> recent;  // the last messages, by number
  };

  static bool hasTwoPublishers(const Link& link);

  mutable std::mutex mutex_;
  std::map<std::string, Link> links_;  // by the frame
};

}  // namespace sfw
