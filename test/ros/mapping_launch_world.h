#pragma once

#include <gtest/gtest.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <structure_from_wifi/Walls.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "octomap_reader.h"
#include "strict_consumers.h"
#include "support/slowdown.h"

namespace sfw {

/// Everything that a mapper publishes, received from before the first test to after the last one,
/// and a robot for a mapper that has none. Topics are those of mapping.launch, to be remapped;
/// parameters of this node say what was launched.
class LaunchWorld : public testing::Test {
 public:
  struct Received {
    std::optional<StrictConsumers> consumers;
    nav_msgs::OccupancyGridConstPtr map, probability, costs, wall_loss;
    nav_msgs::MapMetaDataConstPtr metadata;
    octomap_msgs::OctomapConstPtr binary, full;
    visualization_msgs::MarkerArrayConstPtr markers;
    nav_msgs::PathConstPtr path;
    structure_from_wifi::WallsConstPtr walls;
    std::vector<ros::Subscriber> subscribers;
    ros::SteadyTime last_map;
  };

  static Received& world() { return *received_; }

  template <class Value>
  static Value param(const std::string& name, const Value& otherwise) {
    return ros::param::param("~" + name, otherwise);
  }

  static std::string mapper() { return param<std::string>("mapper", "/mapping"); }

  static std::filesystem::path saveDirectory() {
    std::string directory;
    EXPECT_TRUE(ros::param::get(mapper() + "/ros/save_directory", directory));
    return directory;
  }

  /// Handles messages until something becomes true or real time runs out.
  static bool spinUntil(const std::function<bool()>& done, double timeout_s) {
    const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(timeout_s);
    while (!done() && ros::SteadyTime::now() < deadline) {
      ros::spinOnce();
      ros::WallDuration(0.002).sleep();
    }
    return done();
  }

  /// Waits until no map has come for longer than the time between two updates.
  static void waitUntilQuiet() {
    world().last_map = ros::SteadyTime::now();  // what has come unseen counts as new
    spinUntil([] { return (ros::SteadyTime::now() - world().last_map).toSec() > 1.6 * kSlowdown; },
              60.0 * kSlowdown);
  }

  /// Drives along x = 1..7 m past a wall, faster than real time; false if nobody listens.
  static bool drive() {
    ros::NodeHandle node;
    const ros::Publisher transforms = node.advertise<tf2_msgs::TFMessage>("/tf", 1000);
    const ros::Publisher scans = node.advertise<structure_from_wifi::WifiScan>("wifi_scan", 1000);
    if (!spinUntil([&] { return transforms.getNumSubscribers() && scans.getNumSubscribers(); },
                   30.0)) {
      return false;
    }
    constexpr int kScans = 240;
    const ros::Time start = ros::Time::now() - ros::Duration(3.0);
    for (int i = 0; i < kScans; ++i) {
      const ros::Time stamp = start + ros::Duration(0.01 * i);
      transforms.publish(pose(stamp, 1.0 + 0.025 * i, 2.0 + 0.3 * std::sin(0.05 * i)));
      scans.publish(
          scan(stamp, i > kScans / 2 ? -58.0F : -40.0F, i > kScans / 3 ? -41.0F : -60.0F));
      ros::spinOnce();
      ros::WallDuration(0.004).sleep();
    }
    return true;
  }

 protected:
  static void SetUpTestSuite() {
    received_ = std::make_unique<Received>();
    Received& r = world();
    ros::NodeHandle node;
    r.consumers.emplace(node, param<std::string>("map_frame", "map"));
    r.subscribers.push_back(node.subscribe<nav_msgs::OccupancyGrid>(
        "map", 100, [&r](const nav_msgs::OccupancyGridConstPtr& map) {
          r.map = map;
          r.last_map = ros::SteadyTime::now();
        }));
    keep("map_metadata", r.metadata);
    keep("map_probability", r.probability);
    keep("map_costs", r.costs);
    keep("octomap_binary", r.binary);
    keep("octomap_full", r.full);
    keep("markers", r.markers);
    keep("path", r.path);
    keep("wall_loss", r.wall_loss);
    keep("walls", r.walls);
  }

  static void TearDownTestSuite() {
    std::filesystem::remove_all(saveDirectory().parent_path());
    received_.reset();
  }

 private:
  /// Subscribes so that the last message stands in `last`.
  template <class Message>
  static void keep(const std::string& topic, boost::shared_ptr<const Message>& last) {
    world().subscribers.push_back(ros::NodeHandle().subscribe<Message>(
        topic, 100, [&last](const boost::shared_ptr<const Message>& message) { last = message; }));
  }

  static geometry_msgs::TransformStamped transform(const ros::Time& stamp,
                                                   const std::string& parent,
                                                   const std::string& child, double x, double y) {
    geometry_msgs::TransformStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = parent;
    message.child_frame_id = child;
    message.transform.translation.x = x;
    message.transform.translation.y = y;
    message.transform.rotation.w = 1.0;
    return message;
  }

  static tf2_msgs::TFMessage pose(const ros::Time& stamp, double x, double y) {
    tf2_msgs::TFMessage message;
    message.transforms = {
        transform(stamp, param<std::string>("map_frame", "map"), "odom", 1.0, -2.0),
        transform(stamp, "odom", param<std::string>("antenna_frame", "base_link"), x - 1.0,
                  y + 2.0)};
    return message;
  }

  static structure_from_wifi::WifiScan scan(const ros::Time& stamp, float near_dbm, float far_dbm) {
    structure_from_wifi::WifiScan message;
    message.header.stamp = stamp;
    message.readings.resize(2);
    message.readings[0].bssid = "02:00:00:00:00:01";
    message.readings[0].rssi_dbm = near_dbm;
    message.readings[1].bssid = "02:00:00:00:00:02";
    message.readings[1].rssi_dbm = far_dbm;
    return message;
  }

  static inline std::unique_ptr<Received> received_;
};

}  // namespace sfw
