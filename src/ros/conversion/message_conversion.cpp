#include "ros/conversion/message_conversion.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "structure_from_wifi/octomap_export.h"

namespace sfw {
namespace {

constexpr std::int8_t kUnknownCell = -1;
constexpr std::int8_t kFreeCell = 0;
constexpr std::int8_t kOccupiedCell = 100;

std::int8_t toCell(CellState state) {
  switch (state) {
    case CellState::kFree:
      return kFreeCell;
    case CellState::kOccupied:
      return kOccupiedCell;
    case CellState::kUnknown:
      break;
  }
  return kUnknownCell;
}

/// @param values  of all cells, row-major
nav_msgs::OccupancyGrid toGrid(const GridGeometry& geometry, const std_msgs::Header& header,
                               std::vector<std::int8_t> values) {
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info = toMetaData(geometry, header.stamp);
  message.data = std::move(values);
  return message;
}

/// An access point at its given or estimated position; NaN if it has neither.
structure_from_wifi::AccessPoint toMessage(const AccessPointSummary& summary,
                                           const AccessPointFit* fit) {
  const AccessPoint& access_point = summary.access_point;
  structure_from_wifi::AccessPoint message;
  message.bssid = access_point.bssid.str();
  message.radio = summary.radio ? summary.radio->str() : "";
  message.name = access_point.name;
  message.position = toPoint(access_point.position, access_point.height_m.value_or(0.0));
  if (summary.estimate) {
    message.estimated = 1;
    const Eigen::Matrix2d& covariance = summary.estimate->covariance;
    message.covariance = {covariance(0, 0), covariance(0, 1), covariance(1, 0), covariance(1, 1)};
  } else if (!hasPosition(summary)) {
    message.position.x = message.position.y = std::numeric_limits<double>::quiet_NaN();
  }
  message.readings = static_cast<std::uint32_t>(summary.readings);
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const Position given = summary.given_position.value_or(Position(kNone, kNone));
  message.given_position = toPoint(given, message.position.z);
  message.given_sd = summary.given_position ? access_point.position_sd_m.value_or(kNone) : kNone;
  message.fit_db = kNone;
  message.seems_to_stand_at = toPoint(Position(kNone, kNone), message.position.z);
  if (fit != nullptr) {
    message.fit_db = static_cast<float>(fit->residual_db);
    message.suspect = fit->suspect ? 1 : 0;
    message.seems_to_stand_at = toPoint(fit->estimate.position, message.position.z);
  }
  return message;
}

octomap_msgs::Octomap toOctomap(const octomap::OcTree& tree, const std_msgs::Header& header,
                                bool binary, const std::string& bytes) {
  octomap_msgs::Octomap message;
  message.header = header;
  message.binary = binary ? 1 : 0;
  message.id = tree.getTreeType();
  message.resolution = tree.getResolution();
  message.data.assign(bytes.begin(), bytes.end());
  return message;
}

}  // namespace

geometry_msgs::Point toPoint(const Position& position, double z) {
  geometry_msgs::Point point;
  point.x = position.x();
  point.y = position.y();
  point.z = z;
  return point;
}

geometry_msgs::TransformStamped toPlanarTransform(const ros::Time& stamp, const std::string& parent,
                                                  const std::string& child,
                                                  const Position& position, double yaw_rad) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = position.x();
  message.transform.translation.y = position.y();
  message.transform.rotation.z = std::sin(0.5 * yaw_rad);
  message.transform.rotation.w = std::cos(0.5 * yaw_rad);
  return message;
}

nav_msgs::MapMetaData toMetaData(const GridGeometry& geometry, const ros::Time& load_time) {
  nav_msgs::MapMetaData info;
  info.map_load_time = load_time;
  info.resolution = static_cast<float>(geometry.resolution());
  info.width = static_cast<std::uint32_t>(geometry.width());
  info.height = static_cast<std::uint32_t>(geometry.height());
  info.origin.position = toPoint(geometry.origin(), 0.0);
  info.origin.orientation.w = 1.0;
  return info;
}

nav_msgs::OccupancyGrid toTrinaryGrid(const BeliefMap& belief, const std_msgs::Header& header) {
  return toGrid(belief.geometry(), header,
                belief.converted([](const CellBelief& cell) { return toCell(cell.state); }));
}

nav_msgs::OccupancyGrid toTrinaryGrid(const Grid<CellState>& states,
                                      const std_msgs::Header& header) {
  std::vector<std::int8_t> values;
  values.reserve(states.cells.size());
  for (const CellState state : states.cells) {
    values.push_back(toCell(state));
  }
  return toGrid(states.geometry, header, std::move(values));
}

bool haveSameGeometry(const nav_msgs::MapMetaData& a, const nav_msgs::MapMetaData& b) {
  return a.width == b.width && a.height == b.height && a.resolution == b.resolution &&
         a.origin == b.origin;
}

map_msgs::OccupancyGridUpdate toUpdate(const nav_msgs::OccupancyGrid& before,
                                       const nav_msgs::OccupancyGrid& after) {
  const std::uint32_t width = after.info.width;
  std::uint32_t left = width, right = 0, low = after.info.height, high = 0;
  for (std::size_t i = 0; i < after.data.size(); ++i) {
    if (after.data[i] != before.data[i]) {
      const auto x = static_cast<std::uint32_t>(i % width);
      const auto y = static_cast<std::uint32_t>(i / width);
      left = std::min(left, x);
      right = std::max(right, x);
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  left = std::min(left, right);
  low = std::min(low, high);
  map_msgs::OccupancyGridUpdate update;
  update.header = after.header;
  update.x = static_cast<std::int32_t>(left);
  update.y = static_cast<std::int32_t>(low);
  update.width = right - left + 1;
  update.height = high - low + 1;
  for (std::uint32_t y = low; y <= high; ++y) {
    const auto row = after.data.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * width);
    update.data.insert(update.data.end(), row + left, row + right + 1);
  }
  return update;
}

nav_msgs::OccupancyGrid toProbabilityGrid(const BeliefMap& belief, const std_msgs::Header& header) {
  return toGrid(belief.geometry(), header, belief.converted([](const CellBelief& cell) {
    return cell.known ? static_cast<std::int8_t>(std::lround(100.0F * cell.occupied))
                      : kUnknownCell;
  }));
}

nav_msgs::OccupancyGrid toCostGrid(const Grid<std::int8_t>& costs, const std_msgs::Header& header) {
  return toGrid(costs.geometry, header, costs.cells);
}

nav_msgs::OccupancyGrid toWallLossGrid(const Grid<float>& wall_loss_db,
                                       const std_msgs::Header& header) {
  constexpr float kStepsPerDb = 50.0F;
  constexpr float kHighest = 100.0F;
  std::vector<std::int8_t> steps;
  steps.reserve(wall_loss_db.cells.size());
  for (const float loss_db : wall_loss_db.cells) {
    steps.push_back(
        static_cast<std::int8_t>(std::lround(std::clamp(kStepsPerDb * loss_db, 0.0F, kHighest))));
  }
  return toGrid(wall_loss_db.geometry, header, std::move(steps));
}

structure_from_wifi::Walls toWalls(const Snapshot& snapshot, const std_msgs::Header& header) {
  structure_from_wifi::Walls message;
  message.header = header;
  for (const WallSegment& segment : snapshot.walls) {
    structure_from_wifi::Wall wall;
    wall.start = toPoint(segment.from, 0.0);
    wall.end = toPoint(segment.to, 0.0);
    wall.confidence = static_cast<float>(segment.confidence);
    wall.outer = segment.is_outer;
    message.walls.push_back(wall);
  }
  return message;
}

nav_msgs::Path toPath(const Snapshot& snapshot, const std_msgs::Header& header) {
  nav_msgs::Path path;
  path.header = header;
  for (const PathPose& pose : snapshot.path) {
    geometry_msgs::PoseStamped stamped;
    stamped.header.frame_id = header.frame_id;
    stamped.header.stamp.fromNSec(static_cast<std::uint64_t>(pose.stamp_ns));
    stamped.pose.position = toPoint(pose.antenna_in_map, 0.0);
    stamped.pose.orientation.w = 1.0;
    path.poses.push_back(stamped);
  }
  return path;
}

structure_from_wifi::AccessPoints toAccessPoints(const Snapshot& snapshot,
                                                 const DataFindings& findings,
                                                 const std_msgs::Header& header) {
  structure_from_wifi::AccessPoints message;
  message.header = header;
  for (std::size_t i = 0; i < snapshot.access_points.size(); ++i) {
    message.access_points.push_back(toMessage(snapshot.access_points[i], findings.fit(i)));
  }
  return message;
}

octomap_msgs::Octomap toBinaryOctomap(const octomap::OcTree& tree, const std_msgs::Header& header) {
  return toOctomap(tree, header, true, encodeBinaryMessage(tree));
}

octomap_msgs::Octomap toFullOctomap(const octomap::OcTree& tree, const std_msgs::Header& header) {
  return toOctomap(tree, header, false, encodeFullMessage(tree));
}

}  // namespace sfw
