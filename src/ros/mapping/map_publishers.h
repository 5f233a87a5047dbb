#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <atomic>
#include <cstddef>
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
  /// What a publisher does beside the whole map.
  enum class Updates {
    kNone,
    kRectangles  ///< publish the changed rectangle on `map_updates` instead of a map
  };

  /// Advertises all topics.
  MapPublishers(ros::NodeHandle& node, const std::string& map_frame, const Config& config,
                Updates updates);

  /// When a grid is published.
  enum class When { kChanged, kAlways };

  /// Publishes a snapshot on all topics but the OctoMaps', which are due from now on. Grids that
  /// did not change are not published again, because planners and localisations start anew with
  /// each map. The other messages name the last map by its stamp. After a call that threw, the next
  /// one publishes everything.
  void publish(const std::shared_ptr<const Snapshot>& snapshot, const DataFindings& findings = {},
               When when = When::kChanged);

  /// With updates, publishes the whole map if a new subscriber has only seen an old one.
  void publishDueMap();

  /// Publishes the OctoMaps if they are due and have a subscriber. A new subscriber makes them due
  /// again.
  void publishDueOctomaps();

  /// The last published map, or nullptr. Never waits for publish().
  std::shared_ptr<const PublishedMap> last() const;

 private:
  /// A grid topic, and what it published last.
  struct GridTopic {
    ros::Publisher publisher;
    std::size_t hash = 0;

    void publish(const nav_msgs::OccupancyGrid& grid, When when);
  };

  /// @param before  what subscribers have; nullptr: unknown
  void publishMap(const PublishedMap& map, const PublishedMap* before);
  void publishOctomap(const PublishedMap& map);

  std::string map_frame_;
  Config::Octomap octomap_;
  double footprint_radius_m_;
  mutable std::mutex mutex_;  // around last_
  std::shared_ptr<const PublishedMap> last_;
  std::atomic<bool> octomap_due_{false};  // set by roscpp's thread when a subscriber comes
  std::atomic<bool> map_due_{true};       // likewise
  std::atomic<bool> octomap_failed_{false};
  bool is_incomplete_ = false;  // publish() failed halfway: subscribers have older messages
  Updates updates_;
  GridTopic probability_, costs_, wall_loss_;
  ros::Publisher map_, map_updates_, metadata_, octomap_binary_, octomap_full_, markers_, path_,
      access_points_, walls_;
};

}  // namespace sfw
