#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// A snapshot, the results of its checks, and its published grid.
struct PublishedMap {
  std::shared_ptr<const Snapshot> snapshot;
  DataFindings findings;
  nav_msgs::OccupancyGrid grid;
  double free_m2 = 0.0;  ///< free area of the grid
};

/// Publishes maps on all topics of the mapping nodelet, all latched.
///
/// OctoMaps are made for subscribers only, because they cost more than all other messages together.
/// One thread publishes at a time; any thread may call last().
class MapPublishers {
 public:
  /// Advertises all topics.
  MapPublishers(ros::NodeHandle& node, const std::string& map_frame, const Config& config);

  /// Publishes a snapshot on all topics but the OctoMaps', which are due from now on.
  void publish(const std::shared_ptr<const Snapshot>& snapshot, const DataFindings& findings = {});

  /// Publishes the OctoMaps if they are due and have a subscriber. A new subscriber makes them due
  /// again.
  void publishDueOctomaps();

  /// The last published map, or nullptr. Never waits for publish().
  std::shared_ptr<const PublishedMap> last() const;

 private:
  void publishOctomap(const PublishedMap& map);

  std::string map_frame_;
  Config::Octomap octomap_;
  double footprint_radius_m_;
  mutable std::mutex mutex_;  // around last_
  std::shared_ptr<const PublishedMap> last_;
  std::atomic<bool> octomap_due_{false};  // set by roscpp's thread when a subscriber comes
  ros::Publisher map_, metadata_, probability_, costs_, wall_loss_, octomap_binary_, octomap_full_,
      markers_, path_, access_points_, walls_;
};

}  // namespace sfw
