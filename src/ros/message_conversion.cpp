#include "message_conversion.h"

#include <octomap/OcTree.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "structure_from_wifi/map_picture.h"
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

/// A grid message of `value(cell)`.
template <class Value>
nav_msgs::OccupancyGrid toGrid(const GridGeometry& geometry, const std_msgs::Header& header,
                               Value&& value) {
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info = toMetaData(geometry, header.stamp);
  message.data.reserve(geometry.size());
  Cell c;
  for (c.y = 0; c.y < geometry.height(); ++c.y) {
    for (c.x = 0; c.x < geometry.width(); ++c.x) {
      message.data.push_back(value(c));
    }
  }
  return message;
}

std_msgs::ColorRGBA toColour(const Colour& colour) {
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(colour[0]);
  message.g = static_cast<float>(colour[1]);
  message.b = static_cast<float>(colour[2]);
  message.a = 1.0F;
  return message;
}

geometry_msgs::Point toPoint(const Position& position, double z) {
  geometry_msgs::Point point;
  point.x = position.x();
  point.y = position.y();
  point.z = z;
  return point;
}

visualization_msgs::Marker marker(const std_msgs::Header& header, const char* name, int id,
                                  int type, double size, const Colour& colour) {
  visualization_msgs::Marker message;
  message.header = header;
  message.ns = name;
  message.id = id;
  message.type = type;
  message.pose.orientation.w = 1.0;
  message.scale.x = message.scale.y = message.scale.z = size;
  message.color = toColour(colour);
  return message;
}

visualization_msgs::Marker label(const std_msgs::Header& header, const char* name, int id,
                                 const std::string& text, const geometry_msgs::Point& at,
                                 const Colour& colour) {
  constexpr double kLetterHeight = 0.3;  // [m]
  visualization_msgs::Marker message =
      marker(header, name, id, visualization_msgs::Marker::TEXT_VIEW_FACING, kLetterHeight, colour);
  message.text = text;
  message.pose.position = at;
  return message;
}

visualization_msgs::Marker pathMarker(const Snapshot& snapshot, const std_msgs::Header& header) {
  constexpr double kDot = 0.08;  // [m]
  constexpr double kAboveMap = 0.03;
  visualization_msgs::Marker dots =
      marker(header, "path", 0, visualization_msgs::Marker::SPHERE_LIST, kDot, {1.0, 1.0, 1.0});
  for (const PathPose& pose : snapshot.path) {
    dots.points.push_back(toPoint(pose.antenna_in_map, kAboveMap));
    dots.colors.push_back(toColour(wallCountColour(pose.walls)));
  }
  return dots;
}

void addAccessPoints(const Snapshot& snapshot, const std_msgs::Header& header,
                     visualization_msgs::MarkerArray& markers) {
  constexpr double kBall = 0.3;                // [m]
  constexpr double kUsualHeight = 1.0;         // [m], where the table gives none
  constexpr Colour kViolet{0.75, 0.20, 0.90};  // legible on free and occupied cells alike
  for (std::size_t i = 0; i < snapshot.access_points.size(); ++i) {
    if (!isPlaced(snapshot.access_points[i])) {
      continue;
    }
    const AccessPoint& access_point = snapshot.access_points[i].access_point;
    const double height = access_point.height_m.value_or(kUsualHeight);
    const int id = static_cast<int>(i);
    visualization_msgs::Marker ball =
        marker(header, "access_points", id, visualization_msgs::Marker::SPHERE, kBall, kViolet);
    ball.pose.position = toPoint(access_point.position, height);
    markers.markers.push_back(ball);
    const bool shares_place =
        i > 0 && snapshot.access_points[i - 1].access_point.position == access_point.position;
    if (!shares_place) {  // radios of one router: one name is enough
      markers.markers.push_back(
          label(header, "names", id,
                access_point.name.empty() ? access_point.bssid.str() : access_point.name,
                toPoint(access_point.position + Position(0.0, 0.4), height + kBall), kViolet));
    }
  }
}

void addLegend(const Snapshot& snapshot, const std_msgs::Header& header,
               visualization_msgs::MarkerArray& markers) {
  int most = -1;
  Box area;
  for (const PathPose& pose : snapshot.path) {
    most = std::max(most, pose.walls);
    area.extend(pose.antenna_in_map);
  }
  for (int walls = 0; walls <= most; ++walls) {
    const Position at(area.min().x() + 1.1 * walls, area.min().y() - 1.0);
    markers.markers.push_back(label(header, "legend", walls, "k = " + std::to_string(walls),
                                    toPoint(at, 0.1), wallCountColour(walls)));
  }
}

/// As the table gives it, exactly there, or as estimated; nowhere (NaN) if it could not be placed.
structure_from_wifi::AccessPoint toMessage(const AccessPointSummary& summary) {
  const AccessPoint& access_point = summary.access_point;
  structure_from_wifi::AccessPoint message;
  message.bssid = access_point.bssid.str();
  message.name = access_point.name;
  message.position = toPoint(access_point.position, access_point.height_m.value_or(0.0));
  if (summary.estimate) {
    message.estimated = 1;
    const Eigen::Matrix2d& covariance = summary.estimate->covariance;
    message.covariance = {covariance(0, 0), covariance(0, 1), covariance(1, 0), covariance(1, 1)};
  } else if (!isPlaced(summary)) {
    message.position.x = message.position.y = std::numeric_limits<double>::quiet_NaN();
  }
  message.readings = static_cast<std::uint32_t>(summary.readings);
  message.fit_db = summary.fit ? static_cast<float>(summary.fit->residual_db)
                               : std::numeric_limits<float>::quiet_NaN();
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
  return toGrid(belief.geometry(), header, [&](Cell c) { return toCell(belief.state(c)); });
}

nav_msgs::OccupancyGrid toTrinaryGrid(const Grid<CellState>& states,
                                      const std_msgs::Header& header) {
  return toGrid(states.geometry, header, [&](Cell c) { return toCell(states[c]); });
}

nav_msgs::OccupancyGrid toProbabilityGrid(const BeliefMap& belief, const std_msgs::Header& header) {
  return toGrid(belief.geometry(), header, [&](Cell c) {
    return belief.known(c) ? static_cast<std::int8_t>(std::lround(100.0F * belief.occupied(c)))
                           : kUnknownCell;
  });
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

visualization_msgs::MarkerArray toMarkers(const Snapshot& snapshot,
                                          const std_msgs::Header& header) {
  visualization_msgs::MarkerArray markers;
  visualization_msgs::Marker clear;
  clear.header = header;
  clear.action = visualization_msgs::Marker::DELETEALL;
  markers.markers.push_back(clear);
  if (!snapshot.path.empty()) {
    markers.markers.push_back(pathMarker(snapshot, header));
  }
  addAccessPoints(snapshot, header, markers);
  addLegend(snapshot, header, markers);
  return markers;
}

structure_from_wifi::AccessPoints toAccessPoints(const Snapshot& snapshot,
                                                 const std_msgs::Header& header) {
  structure_from_wifi::AccessPoints message;
  message.header = header;
  for (const AccessPointSummary& summary : snapshot.access_points) {
    message.access_points.push_back(toMessage(summary));
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
