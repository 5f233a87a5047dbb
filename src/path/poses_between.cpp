#include "path/poses_between.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "path/stray_poses.h"

namespace sfw {
namespace {

auto order(const PathPose& pose) {
  return std::make_tuple(pose.robot, pose.stamp_ns, pose.antenna_in_map.x(),
                         pose.antenna_in_map.y());
}

}  // namespace

bool isEarlier(const PathPose& a, const PathPose& b) {
  // Most poses differ in these two; poses are compared a lot.
  return a.robot != b.robot         ? a.robot < b.robot
         : a.stamp_ns != b.stamp_ns ? a.stamp_ns < b.stamp_ns
                                    : order(a) < order(b);
}

std::vector<PathPose> sortedPath(std::vector<PathPose> poses) {
  if (!std::is_sorted(poses.begin(), poses.end(), isEarlier)) {  // they often come sorted
    std::sort(poses.begin(), poses.end(), isEarlier);
  }
  poses.erase(
      std::unique(poses.begin(), poses.end(),
                  [](const PathPose& a, const PathPose& b) { return order(a) == order(b); }),
      poses.end());
  return poses;
}

std::vector<PathPose> posesBetween(const std::vector<PathPose>& path,
                                   const std::vector<bool>& stray,
                                   const std::vector<PathPose>& poses) {
  // A turn between two readings must show. It is a little less than 0.1, so that rounding does not
  // decide about readings that are 0.1 m apart.
  constexpr double kStep = 0.0995;  // [m]
  const double usual_speed_mps = usualSpeed(path);
  const auto isApart = [](const PathPose& a, const PathPose& b) {
    return (a.antenna_in_map - b.antenna_in_map).norm() >= kStep;
  };
  std::vector<PathPose> kept;
  std::size_t next = 0;  // the first pose of the path that is later
  for (const PathPose& pose : poses) {
    while (next < path.size() && path[next].stamp_ns <= pose.stamp_ns) {
      ++next;
    }
    if (next == 0 || next == path.size() || path[next - 1].stamp_ns == pose.stamp_ns ||
        stray[next - 1] || stray[next]) {
      continue;
    }
    const PathPose& from = path[next - 1];
    const PathPose& to = path[next];
    const bool follows = !kept.empty() && kept.back().stamp_ns > from.stamp_ns;
    if (isApart(follows ? kept.back() : from, pose) && isApart(pose, to) &&
        isReachable(from, pose, usual_speed_mps) && isReachable(pose, to, usual_speed_mps)) {
      kept.push_back(pose);
    }
  }
  return kept;
}

}  // namespace sfw
