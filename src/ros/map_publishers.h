#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <atomic>
#include <memory>
#include <string>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Everything that the mapping nodelet publishes, all latched.
///
/// OctoMaps are only made while somebody listens: they cost more than the rest together.
class MapPublishers {
 public:
  /// Advertises all topics.
  MapPublishers(ros::NodeHandle& node, const Config& config);

  /// Publishes a snapshot on all topics.
  void publish(const std::shared_ptr<const Snapshot>& snapshot);

  /// Publishes the last snapshot's OctoMap if somebody has come to listen since it was due.
  void publishToNewcomers();

  /// What `map` carried last.
  const nav_msgs::OccupancyGrid& lastMap() const { return last_map_; }

  /// The last snapshot, or nullptr.
  const std::shared_ptr<const Snapshot>& lastSnapshot() const { return last_snapshot_; }

 private:
  void publishOctomap();

  Config config_;
  std::shared_ptr<const Snapshot> last_snapshot_;
  nav_msgs::OccupancyGrid last_map_;
  std::atomic<bool> octomap_due_{false};  // set by roscpp's thread when a subscriber comes
  ros::Publisher map_, metadata_, probability_, octomap_binary_, octomap_full_, markers_, path_;
};

}  // namespace sfw
