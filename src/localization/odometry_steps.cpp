#include "localization/odometry_steps.h"

#include <algorithm>
#include <cstdint>

namespace sfw {
namespace {

std::optional<Position> poseAt(std::int64_t stamp_ns, const std::vector<PathPose>& poses) {
  constexpr std::int64_t kLongestGapNs = 5'000'000'000;
  const auto after = std::lower_bound(
      poses.begin(), poses.end(), stamp_ns,
      [](const PathPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  if (after == poses.end()) {
    return std::nullopt;
  }
  if (after->stamp_ns == stamp_ns) {
    return after->antenna_in_map;
  }
  if (after == poses.begin() || after->stamp_ns - (after - 1)->stamp_ns > kLongestGapNs) {
    return std::nullopt;
  }
  const PathPose& before = *(after - 1);
  const double share = static_cast<double>(stamp_ns - before.stamp_ns) /
                       static_cast<double>(after->stamp_ns - before.stamp_ns);
  return before.antenna_in_map + share * (after->antenna_in_map - before.antenna_in_map);
}

}  // namespace

std::vector<std::optional<Position>> odometrySteps(const std::vector<Scan>& scans,
                                                   std::vector<PathPose> poses) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const PathPose& a, const PathPose& b) { return a.stamp_ns < b.stamp_ns; });
  std::vector<std::optional<Position>> at;
  at.reserve(scans.size());
  for (const Scan& scan : scans) {
    at.push_back(poseAt(scan.stamp_ns, poses));
  }
  std::vector<std::optional<Position>> steps(scans.size());
  for (std::size_t i = 1; i < scans.size(); ++i) {
    if (at[i] && at[i - 1]) {
      steps[i] = *at[i] - *at[i - 1];
    }
  }
  return steps;
}

}  // namespace sfw
