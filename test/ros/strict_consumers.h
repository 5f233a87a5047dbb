#pragma once

#include <gtest/gtest.h>
#include <octomap_msgs/Octomap.h>
#include <ros/ros.h>

#include <functional>
#include <string>
#include <vector>

#include "consumer_checks.h"
#include "octomap_reader.h"
#include "static_layer.h"

namespace sfw {

/// Takes every message of a mapping nodelet as its strictest consumer would: costmap_2d, amcl,
/// map_saver, rviz, octomap, the aggregator of diagnostics. A bad message fails the running test.
///
/// Messages are taken while the test handles callbacks.
class StrictConsumers {
 public:
  /// @param node   in the namespace of the nodelet's topics
  /// @param frame  of the map
  explicit StrictConsumers(const ros::NodeHandle& node, const std::string& frame = "map")
      : node_(node), frame_(frame), layer_(frame) {
    listen<nav_msgs::OccupancyGrid>("map", [this](const auto& map) { return faultOfMap(map); });
    for (const char* topic : {"map_probability", "map_costs", "wall_loss"}) {
      listen<nav_msgs::OccupancyGrid>(
          topic, [this](const auto& grid) { return consumer::faultOfGrid(grid, frame_); });
    }
    listen<map_msgs::OccupancyGridUpdate>("map_updates", [this](const auto& update) {
      return consumer::faultOfUpdate(update, map_.header.frame_id.empty() ? nullptr : &map_);
    });
    listen<visualization_msgs::MarkerArray>(
        "markers", [this](const auto& array) { return consumer::faultOfMarkers(array, frame_); });
    listen<nav_msgs::Path>(
        "path", [this](const auto& path) { return consumer::faultOfPath(path, frame_); });
    listen<structure_from_wifi::AccessPoints>("access_points", [this](const auto& message) {
      return consumer::faultOfAccessPoints(message, frame_);
    });
    listen<structure_from_wifi::Walls>(
        "walls", [this](const auto& message) { return consumer::faultOfWalls(message, frame_); });
    for (const char* topic : {"octomap_binary", "octomap_full"}) {
      listen<octomap_msgs::Octomap>(topic, [this](const auto& message) {
        return message.header.frame_id != frame_ ? "its frame is '" + message.header.frame_id + "'"
               : OctomapReader::read(message)    ? ""
                                                 : "octomap cannot read it";
      });
    }
    listen<diagnostic_msgs::DiagnosticArray>("/diagnostics", [](const auto& array) {
      for (const diagnostic_msgs::DiagnosticStatus& status : array.status) {
        const std::string fault = consumer::faultOfStatus(status);
        if (!fault.empty()) {
          return status.name + ": " + fault;
        }
      }
      return std::string();
    });
  }
  StrictConsumers(const StrictConsumers&) = delete;
  StrictConsumers& operator=(const StrictConsumers&) = delete;

  /// The costmap.
  StaticLayer& layer() { return layer_; }

  /// The number of messages taken.
  std::size_t messages() const { return messages_; }

 private:
  template <class Message, class FaultOf>
  void listen(const std::string& topic, FaultOf&& fault_of) {
    const boost::function<void(const boost::shared_ptr<const Message>&)> callback =
        [this, topic, fault_of](const boost::shared_ptr<const Message>& message) {
          ++messages_;
          const std::string fault = fault_of(*message);
          EXPECT_EQ(fault, "") << "a message on " << topic << " is bad";
        };
    subscribers_.push_back(node_.subscribe<Message>(topic, 100, callback));
  }

  std::string faultOfMap(const nav_msgs::OccupancyGrid& map) {
    map_ = map;
    const testing::AssertionResult taken = layer_.accept(map);
    std::string fault = taken ? "" : std::string("costmap_2d: ") + taken.message();
    for (const std::string& other :
         {consumer::faultOfGrid(map, frame_), consumer::faultForAmcl(map),
          consumer::faultForMapSaver(map)}) {
      fault = fault.empty() ? other : fault;
    }
    return fault;
  }

  ros::NodeHandle node_;
  std::string frame_;
  StaticLayer layer_;
  nav_msgs::OccupancyGrid map_;  // the last one
  std::vector<ros::Subscriber> subscribers_;
  std::size_t messages_ = 0;
};

}  // namespace sfw
