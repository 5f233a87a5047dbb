#include "ros/mapping/odometry_frame.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>

namespace sfw {
namespace {

/// A frame, its parent, and so on.
std::vector<std::string> ancestors(const std::string& frame, const tf2::BufferCore& transforms) {
  constexpr std::size_t kMost = 100;  // a loop in tf must not hang
  std::vector<std::string> frames{frame};
  std::string parent;
  while (frames.size() < kMost && transforms._getParent(frames.back(), ros::Time(), parent)) {
    frames.push_back(parent);
  }
  return frames;
}

/// Whether a frame moves in another one: static transforms have no stamp.
bool moves(const std::string& frame, const std::string& in, const tf2::BufferCore& transforms) {
  return !transforms.lookupTransform(in, frame, ros::Time()).header.stamp.isZero();
}

}  // namespace

std::vector<std::string> framesBetween(const std::string& from, const std::string& to,
                                       const tf2::BufferCore& transforms) {
  std::vector<std::string> way = ancestors(from, transforms);
  const std::vector<std::string> back = ancestors(to, transforms);
  const auto common = std::find_first_of(way.begin(), way.end(), back.begin(), back.end());
  if (common == way.end()) {
    return {};
  }
  const auto met = std::find(back.begin(), back.end(), *common);
  way.erase(common, way.end());
  way.insert(way.end(), std::make_reverse_iterator(met + 1), back.rend());
  return way;
}

std::string odometryFrame(const RosSettings& config, const tf2::BufferCore& transforms) {
  if (!config.odom_frame.empty()) {
    return config.odom_frame == config.map_frame ? "" : config.odom_frame;
  }
  try {
    const std::vector<std::string> way =
        framesBetween(config.map_frame, config.antenna_frame, transforms);
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
      if (moves(way[i], config.map_frame, transforms)) {
        return moves(config.antenna_frame, way[i], transforms) ? way[i] : "";
      }
    }
  } catch (const std::exception&) {
    return "";  // tf has no common time yet
  }
  return "";
}

}  // namespace sfw
