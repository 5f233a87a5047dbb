#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <structure_from_wifi/AccessPoints.h>
#include <structure_from_wifi/Walls.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

namespace sfw {

/// What each consumer of a message needs, as a check of one message: empty, or what is wrong with
/// it. costmap_2d has StaticLayer, and octomap OctomapReader.
namespace consumer {

inline bool isFinite(const geometry_msgs::Point& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// As rviz's validateQuaternions.
inline bool isNormalised(const geometry_msgs::Quaternion& q) {
  constexpr double kTolerance = 1e-3;
  return std::abs(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1.0) < kTolerance;
}

/// rviz's map display and map_saver: a finite grid whose data have its size. Values are percents,
/// or -1 for unknown; map_saver would write others as unknown without a word.
inline std::string faultOfGrid(const nav_msgs::OccupancyGrid& grid, const std::string& frame) {
  const nav_msgs::MapMetaData& info = grid.info;
  if (grid.header.frame_id != frame) {
    return "its frame is '" + grid.header.frame_id + "'";
  }
  if (!(info.resolution > 0.0F && std::isfinite(info.resolution))) {
    return "its resolution is not positive";
  }
  if (info.width == 0 || info.height == 0 ||
      grid.data.size() != std::size_t{info.width} * info.height) {
    return "its size is 0 or does not match the data";
  }
  if (!isFinite(info.origin.position) || !isNormalised(info.origin.orientation)) {
    return "its origin is no pose";
  }
  return std::all_of(grid.data.begin(), grid.data.end(),
                     [](std::int8_t value) { return value >= -1 && value <= 100; })
             ? ""
             : "a cell is neither -1 nor 0 to 100";
}

/// amcl takes exactly 100 as an obstacle and 0 as free, so nothing between may mean either.
inline std::string faultForAmcl(const nav_msgs::OccupancyGrid& map) {
  const bool known = std::all_of(map.data.begin(), map.data.end(), [](std::int8_t value) {
    return value == -1 || value == 0 || value == 100;
  });
  return known ? "" : "amcl takes a cell that is neither 0 nor 100 as unknown";
}

/// map_server's map_saver and map_server again: the trinary states come back as they were.
inline std::string faultForMapSaver(const nav_msgs::OccupancyGrid& map) {
  constexpr int kFreeBelow = 25, kOccupiedFrom = 65;  // [%], its defaults
  for (const std::int8_t value : map.data) {
    const int saved = value >= 0 && value <= kFreeBelow ? 0 : value >= kOccupiedFrom ? 100 : -1;
    if (saved != value) {
      return "map_saver changes a cell of " + std::to_string(value);
    }
  }
  return "";
}

/// costmap_2d's static layer checks no bounds: an update outside of the map ends move_base.
inline std::string faultOfUpdate(const map_msgs::OccupancyGridUpdate& update,
                                 const nav_msgs::OccupancyGrid* map) {
  if (map == nullptr) {
    return "it comes before the first map";
  }
  if (update.header.frame_id != map->header.frame_id) {
    return "its frame is '" + update.header.frame_id + "'";
  }
  if (update.x < 0 || update.y < 0 || update.width == 0 || update.height == 0 ||
      std::uint64_t{update.width} + static_cast<std::uint32_t>(update.x) > map->info.width ||
      std::uint64_t{update.height} + static_cast<std::uint32_t>(update.y) > map->info.height) {
    return "it reaches outside of the map";
  }
  return update.data.size() == std::size_t{update.width} * update.height
             ? ""
             : "its size does not match the data";
}

inline bool isList(const visualization_msgs::Marker& marker) {
  using Marker = visualization_msgs::Marker;
  return marker.type == Marker::LINE_STRIP || marker.type == Marker::LINE_LIST ||
         marker.type == Marker::CUBE_LIST || marker.type == Marker::SPHERE_LIST ||
         marker.type == Marker::POINTS || marker.type == Marker::TRIANGLE_LIST;
}

inline bool isColour(const std_msgs::ColorRGBA& colour) {
  const auto is_share = [](float value) { return value >= 0.0F && value <= 1.0F; };
  return is_share(colour.r) && is_share(colour.g) && is_share(colour.b) && is_share(colour.a);
}

/// rviz, which shows nothing of an array in which one marker is bad.
inline std::string faultOfMarker(const visualization_msgs::Marker& marker,
                                 const std::string& frame) {
  using Marker = visualization_msgs::Marker;
  const bool is_drawn = marker.action == Marker::ADD;
  if (marker.action == Marker::DELETEALL) {
    return "";
  }
  if (marker.header.frame_id != frame) {
    return "its frame is '" + marker.header.frame_id + "'";
  }
  if (is_drawn && (!isFinite(marker.pose.position) || !isNormalised(marker.pose.orientation))) {
    return "its pose is not finite, or not normalised";
  }
  const geometry_msgs::Vector3& scale = marker.scale;
  const bool is_line = marker.type == Marker::LINE_STRIP || marker.type == Marker::LINE_LIST;
  const bool has_scale = marker.type == Marker::TEXT_VIEW_FACING ? scale.z > 0.0
                         : is_line                               ? scale.x > 0.0
                                   : scale.x > 0.0 && scale.y > 0.0 && scale.z > 0.0;
  if (is_drawn && !(has_scale && std::isfinite(scale.x + scale.y + scale.z))) {
    return "its scale is not positive";
  }
  if (!isColour(marker.color) ||
      !std::all_of(marker.colors.begin(), marker.colors.end(), isColour)) {
    return "a colour is not in [0, 1]";
  }
  if (!isList(marker)) {
    return is_drawn && marker.type == Marker::TEXT_VIEW_FACING && marker.text.empty()
               ? "its text is empty"
               : "";
  }
  if (!marker.colors.empty() && marker.colors.size() != marker.points.size()) {
    return "it has not one colour for each point";
  }
  if (marker.type == Marker::LINE_LIST && marker.points.size() % 2 != 0) {
    return "a line has one end";
  }
  return std::all_of(marker.points.begin(), marker.points.end(), isFinite)
             ? ""
             : "a point is not finite";
}

inline std::string faultOfMarkers(const visualization_msgs::MarkerArray& array,
                                  const std::string& frame) {
  std::set<std::pair<std::string, int>> names;
  for (const visualization_msgs::Marker& marker : array.markers) {
    const std::string name = marker.ns + "/" + std::to_string(marker.id);
    const std::string fault = faultOfMarker(marker, frame);
    if (!fault.empty()) {
      return name + ": " + fault;
    }
    const bool is_drawn = marker.action == visualization_msgs::Marker::ADD;
    if (is_drawn && !names.emplace(marker.ns, marker.id).second) {
      return name + " comes twice";
    }
  }
  return "";
}

inline std::string faultOfPath(const nav_msgs::Path& path, const std::string& frame) {
  if (path.header.frame_id != frame) {
    return "its frame is '" + path.header.frame_id + "'";
  }
  for (const geometry_msgs::PoseStamped& pose : path.poses) {
    if (pose.header.frame_id != frame || !isFinite(pose.pose.position) ||
        !isNormalised(pose.pose.orientation)) {
      return "a pose is not finite, not normalised or in another frame";
    }
  }
  return "";
}

/// As the message file promises: x and y are both numbers or both NaN.
inline std::string faultOfAccessPoints(const structure_from_wifi::AccessPoints& message,
                                       const std::string& frame) {
  if (message.header.frame_id != frame) {
    return "its frame is '" + message.header.frame_id + "'";
  }
  std::set<std::string> addresses;
  for (const structure_from_wifi::AccessPoint& one : message.access_points) {
    const geometry_msgs::Point& at = one.position;
    const auto& covariance = one.covariance;
    if (std::isnan(at.x) != std::isnan(at.y) || std::isinf(at.x) || std::isinf(at.y) ||
        !std::isfinite(at.z)) {
      return one.bssid + ": its position is neither known nor unknown";
    }
    if (!std::all_of(covariance.begin(), covariance.end(),
                     [](double value) { return std::isfinite(value); }) ||
        covariance[0] < 0.0 || covariance[3] < 0.0 || covariance[1] != covariance[2]) {
      return one.bssid + ": its covariance is none";
    }
    if (one.suspect && !isFinite(one.seems_to_stand_at)) {
      return one.bssid + ": it is suspect without another position";
    }
    if (!addresses.insert(one.bssid).second) {
      return one.bssid + " comes twice";
    }
  }
  return "";
}

inline std::string faultOfWalls(const structure_from_wifi::Walls& message,
                                const std::string& frame) {
  if (message.header.frame_id != frame) {
    return "its frame is '" + message.header.frame_id + "'";
  }
  const bool good = std::all_of(message.walls.begin(), message.walls.end(), [](const auto& wall) {
    return isFinite(wall.start) && isFinite(wall.end) && wall.confidence >= 0.0F &&
           wall.confidence <= 1.0F;
  });
  return good ? "" : "a wall is not finite, or its confidence no probability";
}

/// diagnostic_aggregator and rqt_robot_monitor: a name and a known level, each key once.
inline std::string faultOfStatus(const diagnostic_msgs::DiagnosticStatus& status) {
  if (status.name.empty() || status.message.empty() ||
      status.level > diagnostic_msgs::DiagnosticStatus::STALE) {
    return "it has no name, no message or an unknown level";
  }
  std::set<std::string> keys;
  for (const diagnostic_msgs::KeyValue& value : status.values) {
    if (value.key.empty() || !keys.insert(value.key).second) {
      return "the key '" + value.key + "' is empty or comes twice";
    }
  }
  return "";
}

}  // namespace consumer
}  // namespace sfw
