// The strict stand-ins of consumers take good messages and name the fault of bad ones.

#include "consumer_checks.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

namespace sfw {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Expects that a good message is taken, and that none is with one of the faults.
template <class Message, class FaultOf>
void expectFaultsSeen(const Message& good, FaultOf&& fault_of,
                      const std::vector<std::function<void(Message&)>>& faults) {
  EXPECT_EQ(fault_of(good), "");
  for (std::size_t i = 0; i < faults.size(); ++i) {
    Message bad = good;
    faults[i](bad);
    EXPECT_NE(fault_of(bad), "") << "fault " << i;
  }
}

nav_msgs::OccupancyGrid goodMap() {
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = "map";
  map.info.resolution = 0.05F;
  map.info.width = 3;
  map.info.height = 2;
  map.info.origin.orientation.w = 1.0;
  map.data = {-1, 0, 100, 0, -1, 100};
  return map;
}

TEST(ConsumerChecks, SeeTheFaultsOfGrids) {
  using Map = nav_msgs::OccupancyGrid;
  expectFaultsSeen<Map>(
      goodMap(), [](const Map& map) { return consumer::faultOfGrid(map, "map"); },
      {[](Map& map) { map.header.frame_id = ""; }, [](Map& map) { map.info.resolution = 0.0F; },
       [](Map& map) { map.info.width = 0; }, [](Map& map) { map.data.pop_back(); },
       [](Map& map) { map.info.origin.position.y = kNan; },
       [](Map& map) { map.info.origin.orientation.w = 0.0; }, [](Map& map) { map.data[0] = 101; },
       [](Map& map) { map.data[0] = -2; }});
  expectFaultsSeen<Map>(goodMap(), consumer::faultForAmcl, {[](Map& map) { map.data[3] = 99; }});
  expectFaultsSeen<Map>(goodMap(), consumer::faultForMapSaver,
                        {[](Map& map) { map.data[3] = 10; }, [](Map& map) { map.data[3] = 50; }});
}

TEST(ConsumerChecks, SeeTheFaultsOfUpdates) {
  using Update = map_msgs::OccupancyGridUpdate;
  const nav_msgs::OccupancyGrid map = goodMap();
  Update update;
  update.header.frame_id = "map";
  update.x = 1;
  update.width = 2;
  update.height = 1;
  update.data = {0, 100};
  const auto fault_of = [&](const Update& one) { return consumer::faultOfUpdate(one, &map); };
  expectFaultsSeen<Update>(
      update, fault_of,
      {[](Update& one) { one.header.frame_id = "odom"; }, [](Update& one) { one.x = -1; },
       [](Update& one) { one.x = 2; }, [](Update& one) { one.y = 2; },
       [](Update& one) { one.width = 0; }, [](Update& one) { one.height = 0xffffffffU; },
       [](Update& one) { one.data.pop_back(); }});
  EXPECT_NE(consumer::faultOfUpdate(update, nullptr), "");
}

TEST(ConsumerChecks, SeeTheFaultsOfMarkers) {
  using Array = visualization_msgs::MarkerArray;
  Array array;
  array.markers.resize(2);
  for (visualization_msgs::Marker& marker : array.markers) {
    marker.header.frame_id = "map";
    marker.ns = "walls";
    marker.type = visualization_msgs::Marker::LINE_LIST;
    marker.pose.orientation.w = 1.0;
    marker.scale.x = 0.1;
    marker.points.resize(2);
    marker.colors.resize(2);
  }
  array.markers[1].id = 1;
  const auto fault_of = [](const Array& one) { return consumer::faultOfMarkers(one, "map"); };
  expectFaultsSeen<Array>(array, fault_of,
                          {[](Array& one) { one.markers[0].header.frame_id = ""; },
                           [](Array& one) { one.markers[0].pose.position.x = kNan; },
                           [](Array& one) { one.markers[0].pose.orientation.w = 0.5; },
                           [](Array& one) { one.markers[0].scale.x = 0.0; },
                           [](Array& one) { one.markers[0].scale.y = kNan; },
                           [](Array& one) { one.markers[0].color.a = 1.5F; },
                           [](Array& one) { one.markers[0].colors.pop_back(); },
                           [](Array& one) { one.markers[0].points[1].z = kNan; },
                           [](Array& one) { one.markers[1].id = 0; },
                           [](Array& one) {
                             one.markers[1].points.pop_back();
                             one.markers[1].colors.pop_back();
                           },
                           [](Array& one) {
                             one.markers[1].type = visualization_msgs::Marker::TEXT_VIEW_FACING;
                             one.markers[1].scale.z = 0.3;
                           }});
}

TEST(ConsumerChecks, SeeTheFaultsOfThePath) {
  nav_msgs::Path path;
  path.header.frame_id = "map";
  path.poses.resize(1);
  path.poses[0].header.frame_id = "map";
  path.poses[0].pose.orientation.w = 1.0;
  const auto fault_of = [](const nav_msgs::Path& one) { return consumer::faultOfPath(one, "map"); };
  expectFaultsSeen<nav_msgs::Path>(
      path, fault_of,
      {[](nav_msgs::Path& one) { one.header.frame_id = "odom"; },
       [](nav_msgs::Path& one) { one.poses[0].header.frame_id = ""; },
       [](nav_msgs::Path& one) { one.poses[0].pose.position.y = kNan; },
       [](nav_msgs::Path& one) { one.poses[0].pose.orientation.w = 0.0; }});
}

TEST(ConsumerChecks, SeeTheFaultsOfAccessPointsAndWalls) {
  using AccessPoints = structure_from_wifi::AccessPoints;
  AccessPoints table;
  table.header.frame_id = "map";
  table.access_points.resize(2);
  table.access_points[0].bssid = "02:00:00:00:00:01";
  table.access_points[0].position.x = table.access_points[0].position.y = kNan;
  expectFaultsSeen<AccessPoints>(
      table, [](const auto& one) { return consumer::faultOfAccessPoints(one, "map"); },
      {[](AccessPoints& one) { one.header.frame_id = ""; },
       [](AccessPoints& one) { one.access_points[0].position.x = 1.0; },
       [](AccessPoints& one) { one.access_points[1].covariance[0] = kNan; },
       [](AccessPoints& one) { one.access_points[1].covariance[0] = -1.0; },
       [](AccessPoints& one) { one.access_points[1].bssid = "02:00:00:00:00:01"; },
       [](AccessPoints& one) {
         one.access_points[1].suspect = 1;
         one.access_points[1].seems_to_stand_at.x = kNan;
       }});

  using Walls = structure_from_wifi::Walls;
  Walls walls;
  walls.header.frame_id = "map";
  walls.walls.resize(1);
  expectFaultsSeen<Walls>(walls, [](const auto& one) { return consumer::faultOfWalls(one, "map"); },
                          {[](Walls& one) { one.header.frame_id = ""; },
                           [](Walls& one) { one.walls[0].start.x = kNan; },
                           [](Walls& one) { one.walls[0].confidence = 1.5F; }});
}

TEST(ConsumerChecks, SeeTheFaultsOfDiagnostics) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  Status status;
  status.name = "mapping: map";
  status.message = "There is no map yet.";
  status.values.resize(2);
  status.values[0].key = "readings";
  status.values[1].key = "cells";
  expectFaultsSeen<Status>(
      status, consumer::faultOfStatus,
      {[](Status& one) { one.name = ""; }, [](Status& one) { one.message = ""; },
       [](Status& one) { one.level = 4; }, [](Status& one) { one.values[0].key = ""; },
       [](Status& one) { one.values[1].key = "readings"; }});
}

}  // namespace
}  // namespace sfw
