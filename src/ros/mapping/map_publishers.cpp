#include "ros/mapping/map_publishers.h"

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/Path.h>
#include <octomap/OcTree.h>
#include <octomap_msgs/Octomap.h>
#include <structure_from_wifi/AccessPoints.h>
#include <structure_from_wifi/Walls.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>

#include "ros/conversion/markers.h"
#include "ros/conversion/message_conversion.h"
#include "structure_from_wifi/octomap_export.h"
#include "structure_from_wifi/planning_costs.h"

namespace sfw {
namespace {

double freeArea(const nav_msgs::OccupancyGrid& grid) {
  const double edge_m = static_cast<double>(grid.info.resolution);
  return static_cast<double>(std::count(grid.data.begin(), grid.data.end(), std::int8_t{0})) *
         edge_m * edge_m;
}

/// Whether two grids have the same cells at the same places.
bool haveSameCells(const nav_msgs::OccupancyGrid& a, const nav_msgs::OccupancyGrid& b) {
  return haveSameGeometry(a.info, b.info) && a.data == b.data;
}

}  // namespace

MapPublishers::MapPublishers(ros::NodeHandle& node, const std::string& map_frame,
                             const Config& config, Updates updates)
    : map_frame_(map_frame),
      octomap_(config.octomap),
      footprint_radius_m_(config.path.footprint_radius_m),
      updates_(updates) {
  constexpr bool kLatched = true;
  const auto map_wanted = [this](const ros::SingleSubscriberPublisher&) { map_due_ = true; };
  map_ = node.advertise<nav_msgs::OccupancyGrid>("map", 1, map_wanted, {}, {}, kLatched);
  if (updates_ == Updates::kRectangles) {
    map_updates_ = node.advertise<map_msgs::OccupancyGridUpdate>("map_updates", 10);
  }
  metadata_ = node.advertise<nav_msgs::MapMetaData>("map_metadata", 1, kLatched);
  probability_.publisher = node.advertise<nav_msgs::OccupancyGrid>("map_probability", 1, kLatched);
  costs_.publisher = node.advertise<nav_msgs::OccupancyGrid>("map_costs", 1, kLatched);
  wall_loss_.publisher = node.advertise<nav_msgs::OccupancyGrid>("wall_loss", 1, kLatched);
  markers_ = node.advertise<visualization_msgs::MarkerArray>("markers", 1, kLatched);
  path_ = node.advertise<nav_msgs::Path>("path", 1, kLatched);
  access_points_ = node.advertise<structure_from_wifi::AccessPoints>("access_points", 1, kLatched);
  walls_ = node.advertise<structure_from_wifi::Walls>("walls", 1, kLatched);
  const auto connected = [this](const ros::SingleSubscriberPublisher&) { octomap_due_ = true; };
  octomap_binary_ =
      node.advertise<octomap_msgs::Octomap>("octomap_binary", 1, connected, {}, {}, kLatched);
  octomap_full_ =
      node.advertise<octomap_msgs::Octomap>("octomap_full", 1, connected, {}, {}, kLatched);
}

void MapPublishers::GridTopic::publish(const nav_msgs::OccupancyGrid& grid, When when) {
  const std::string_view cells(reinterpret_cast<const char*>(grid.data.data()), grid.data.size());
  const std::size_t now = std::hash<std::string_view>()(cells);
  if (when == When::kAlways || now != hash) {
    hash = now;
    publisher.publish(grid);
  }
}

void MapPublishers::publish(const std::shared_ptr<const Snapshot>& snapshot,
                            const DataFindings& findings, When when) {
  std_msgs::Header header;
  header.frame_id = map_frame_;
  header.stamp = ros::Time::now();
  const std::shared_ptr<const PublishedMap> before = is_incomplete_ ? nullptr : last();
  is_incomplete_ = true;  // until all is published
  nav_msgs::OccupancyGrid grid = toTrinaryGrid(snapshot->belief, header);
  if (when == When::kChanged && before && haveSameCells(grid, before->grid)) {
    grid = before->grid;
    header = grid.header;
  } else {
    when = When::kAlways;
  }
  const double free_m2 = freeArea(grid);
  const auto published = std::make_shared<const PublishedMap>(
      PublishedMap{snapshot, findings, std::move(grid), free_m2});
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    last_ = published;
  }
  if (when == When::kAlways) {
    publishMap(*published, before.get());
  }
  if (when == When::kAlways || octomap_failed_) {
    octomap_due_ = true;
  }
  probability_.publish(toProbabilityGrid(snapshot->probability, header), when);
  costs_.publish(toCostGrid(planningCosts(*snapshot, footprint_radius_m_), header), when);
  if (snapshot->tomography) {
    wall_loss_.publish(toWallLossGrid(snapshot->tomography->wall_loss, header), when);
  }
  path_.publish(toPath(*snapshot, header));
  markers_.publish(toMarkers(*snapshot, findings, header));
  access_points_.publish(toAccessPoints(*snapshot, findings, header));
  walls_.publish(toWalls(*snapshot, header));
  is_incomplete_ = false;
}

void MapPublishers::publishMap(const PublishedMap& map, const PublishedMap* before) {
  if (updates_ == Updates::kRectangles && before != nullptr && !map_due_ &&
      haveSameGeometry(map.grid.info, before->grid.info)) {
    map_updates_.publish(toUpdate(before->grid, map.grid));
    return;
  }
  map_due_ = false;
  map_.publish(map.grid);
  metadata_.publish(map.grid.info);
}

void MapPublishers::publishDueMap() {
  const std::shared_ptr<const PublishedMap> map = last();
  // Without updates, the latched map is the last one.
  if (updates_ == Updates::kRectangles && map && map_due_.exchange(false)) {
    try {
      map_.publish(map->grid);
    } catch (...) {
      map_due_ = true;
      throw;
    }
  }
}

void MapPublishers::publishDueOctomaps() {
  const bool listened_to =
      octomap_binary_.getNumSubscribers() > 0 || octomap_full_.getNumSubscribers() > 0;
  const std::shared_ptr<const PublishedMap> map = last();
  if (map && listened_to && octomap_due_.exchange(false) &&
      octomapReaches(map->snapshot->belief.geometry())) {
    octomap_failed_ = true;  // until it is published; publish() makes it due again
    publishOctomap(*map);
    octomap_failed_ = false;
  }
}

std::shared_ptr<const PublishedMap> MapPublishers::last() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

void MapPublishers::publishOctomap(const PublishedMap& map) {
  const auto tree = toOctomap(map.snapshot->belief, octomap_);
  if (octomap_binary_.getNumSubscribers() > 0) {
    octomap_binary_.publish(toBinaryOctomap(*tree, map.grid.header));
  }
  if (octomap_full_.getNumSubscribers() > 0) {
    octomap_full_.publish(toFullOctomap(*tree, map.grid.header));
  }
}

}  // namespace sfw
