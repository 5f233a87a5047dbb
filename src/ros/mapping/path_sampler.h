#pragma once

#include <tf2/buffer_core.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ros/conversion/ros_settings.h"
#include "ros/mapping/localization.h"

namespace sfw {

/// Samples in tf how the antenna moved between the observations of a radio.
///
/// A scan of all channels takes seconds, in which the robot drives on. Samples are taken at whole
/// tenths of a second between the first and the last observation. So the samples do not depend on
/// the order or the time of arrival. A robot that stands still has none. Not thread-safe.
class PathSampler {
 public:
  explicit PathSampler(const RosSettings& config);

  /// Extends the sampled time to an observation, if tf can still have transforms of that time.
  /// Never waits. O(samples).
  /// @return the new samples, without those that tf does not have
  std::vector<LocatedPose> extendTo(std::int64_t stamp_ns, const tf2::BufferCore& transforms);

  /// Forgets which time is sampled.
  void clear() { sampled_.reset(); }

 private:
  RosSettings config_;
  std::int64_t most_steps_;                                       // of one extension
  std::optional<std::pair<std::int64_t, std::int64_t>> sampled_;  // first and last [steps]
};

}  // namespace sfw
