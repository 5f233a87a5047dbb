#include "ros/mapping/path_sampler.h"

#include <algorithm>

namespace sfw {
namespace {

constexpr std::int64_t kStep = 100'000'000;  // [ns]
constexpr double kStandsStill = 0.002;       // [m] in one step

ros::Time timeOf(std::int64_t step) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(step * kStep));
  return time;
}

}  // namespace

PathSampler::PathSampler(const RosSettings& config)
    : config_(config),
      // An observation may wait for its transform, and then tf has forgotten that much of the past.
      most_steps_(static_cast<std::int64_t>(
          1e9 * std::max(0.0, config.tf_cache_s - config.transform_timeout_s) / kStep)) {}

std::vector<LocatedPose> PathSampler::extendTo(std::int64_t stamp_ns,
                                               const tf2::BufferCore& transforms) {
  const std::int64_t before = stamp_ns / kStep;  // the last step that is not later
  if (stamp_ns <= 0) {
    return {};
  }
  if (!sampled_) {
    sampled_ = {before + 1, before};
    return {};
  }
  std::int64_t first = before + 1;
  std::int64_t last = sampled_->first - 1;
  if (before > sampled_->second) {
    first = std::max(sampled_->second + 1, before - most_steps_);
    last = before;
    sampled_->second = before;
  } else if (first < sampled_->first) {
    last = std::min(last, first + most_steps_);
    sampled_->first = first;
  }
  std::vector<LocatedPose> way;
  std::optional<LocatedPose> previous =
      first > last ? std::nullopt : locatePose(timeOf(first - 1), config_, transforms);
  for (std::int64_t step = first; step <= last; ++step) {
    std::optional<LocatedPose> sample = locatePose(timeOf(step), config_, transforms);
    if (sample &&
        !(previous &&
          (sample->pose.antenna_in_map - previous->pose.antenna_in_map).norm() < kStandsStill)) {
      way.push_back(*sample);
    }
    previous = std::move(sample);
  }
  return way;
}

}  // namespace sfw
