// Sessions of the mapping nodelet: what it saves, keeps and takes up again.

#include <geometry_msgs/PointStamped.h>
#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/GetMap.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <structure_from_wifi/AccessPoints.h>
#include <structure_from_wifi/ClearRegion.h>
#include <structure_from_wifi/LoadMap.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "mapping_nodelet_world.h"
#include "ros/service_call.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

class NodeletSessionTest : public NodeletWorld {
 protected:
  /// Readings along a line of 3 m; returns how many.
  std::size_t drive(double start_s = 0.0, double y = 1.0) {
    constexpr int kScans = 60;
    for (int i = 0; i < kScans; ++i) {
      sendPose(start_s + 0.05 * i, 0.05 * i, y);
      sendScan(start_s + 0.05 * i, {{kNear, -50.0F - static_cast<float>(i % 7)}, {kFar, -60.0F}});
    }
    return std::size_t{2} * kScans;
  }

  void reset() {
    std_srvs::Trigger call;
    ASSERT_TRUE(callService(name_ + "/mapping/reset", call));
    EXPECT_TRUE(call.response.success);
  }

  structure_from_wifi::LoadMap::Response loadSession(const std::string& directory) {
    structure_from_wifi::LoadMap call;
    call.request.directory = directory;
    EXPECT_TRUE(callService(name_ + "/mapping/load_map", call));
    return call.response;
  }

  void pause(bool pause) {
    std_srvs::SetBool call;
    call.request.data = pause ? 1 : 0;
    ASSERT_TRUE(callService(name_ + "/mapping/pause", call));
    EXPECT_TRUE(call.response.success);
  }

  std::size_t freeCells() const {
    return map_ ? static_cast<std::size_t>(std::count(map_->data.begin(), map_->data.end(), 0)) : 0;
  }

  bool mapAppears() {
    return spinUntil([&] { return freeCells() > 0; }, 30.0 * kSlowdown);
  }

  /// The map last published, which may be on its way still.
  nav_msgs::OccupancyGrid servedMap() const {
    nav_msgs::GetMap call;
    EXPECT_TRUE(callService(name_ + "/dynamic_map", call));
    return call.response.map;
  }

  static std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(NodeletSessionTest, SavingNothingFailsWithTheReason) {
  load();
  const auto response = save("nothing");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("no message has come on " + name_ + "/wifi_scan"),
            std::string::npos)
      << response.message;
  EXPECT_FALSE(fs::exists(folder_ / "nothing"));
}

TEST_F(NodeletSessionTest, SavingNeverReplacesAnotherSession) {
  load();
  const std::size_t readings = drive();
  ASSERT_EQ(rows(readings).size(), readings);
  const std::string first = contentOf(folder_ / "saved" / "readings.csv");
  EXPECT_EQ(save("saved").message, (folder_ / "saved").string()) << "the same session goes on";
  reset();
  sendPose(100.0, 1.0, 1.0);
  sendScan(100.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  EXPECT_EQ(save("saved").message, (folder_ / "saved_2").string());
  EXPECT_EQ(contentOf(folder_ / "saved" / "readings.csv"), first);
}

TEST_F(NodeletSessionTest, ALoadedSessionGoesOnAndMerges) {
  load();
  const std::size_t readings = drive();
  ASSERT_EQ(rows(readings).size(), readings);
  reset();
  const std::size_t more = drive(100.0, 2.0);
  ASSERT_EQ(rows(more).size(), more);
  const auto response = loadSession("saved");
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_EQ(rows(readings + more).size(), readings + more);
}

TEST_F(NodeletSessionTest, ABadSessionIsRefusedAndTheMapStays) {
  load();
  const std::size_t readings = drive();
  ASSERT_EQ(rows(readings).size(), readings);
  fs::copy(folder_ / "saved", folder_ / "cut");
  fs::resize_file(folder_ / "cut" / "readings.csv",
                  fs::file_size(folder_ / "cut" / "readings.csv") - 3);
  for (const std::string& name : {std::string("cut"), std::string("none"), std::string("../x"),
                                  std::string(), std::string(";id;")}) {
    const auto response = loadSession(name);
    EXPECT_FALSE(response.success) << name;
    EXPECT_FALSE(response.message.empty());
  }
  EXPECT_EQ(rows(readings).size(), readings);
}

TEST_F(NodeletSessionTest, UnloadingSavesAndResumingGoesOn) {
  load();
  const std::size_t readings = drive();
  ASSERT_EQ(rows(readings).size(), readings);
  secondsToUnload();
  const fs::path autosave = folder_ / ("autosave_" + name_.substr(1));
  const std::string first = contentOf(autosave / "readings.csv");
  EXPECT_EQ(first, contentOf(folder_ / "saved" / "readings.csv"));
  EXPECT_TRUE(fs::exists(autosave / "map.pgm"));

  ros::param::set(name_ + "/mapping/ros/resume", true);
  load();
  EXPECT_EQ(rows(readings).size(), readings);
  const std::size_t more = drive(100.0, 2.0);
  EXPECT_EQ(rows(readings + more).size(), readings + more);
  secondsToUnload();
  EXPECT_GT(contentOf(autosave / "readings.csv").size(), first.size());
}

TEST_F(NodeletSessionTest, ANewSessionKeepsTheAutosaveOfTheLastOne) {
  load();
  const std::size_t readings = drive();
  ASSERT_EQ(rows(readings).size(), readings);
  secondsToUnload();
  const fs::path autosave = folder_ / ("autosave_" + name_.substr(1));
  const std::string first = contentOf(autosave / "readings.csv");
  load();
  sendPose(100.0, 1.0, 1.0);
  sendScan(100.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  secondsToUnload();
  EXPECT_NE(contentOf(autosave / "readings.csv"), first);
  EXPECT_EQ(contentOf(autosave.string() + "_before/readings.csv"), first);
}

TEST_F(NodeletSessionTest, PausedReadingsAreDropped) {
  load();
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  pause(true);
  bool delivered = false;  // to the nodelet too, which subscribed before
  const ros::Subscriber scans = ros::NodeHandle().subscribe<structure_from_wifi::WifiScan>(
      name_ + "/wifi_scan", 10,
      [&](const structure_from_wifi::WifiScanConstPtr&) { delivered = true; });
  sendScan(0.0, {{kFar, -60.0F}});
  ASSERT_TRUE(spinUntil([&] { return delivered; }, 10.0));
  pause(false);
  sendPose(1.0, 1.0, 2.0);
  sendScan(1.0, {{kNear, -51.0F}});
  EXPECT_EQ(rows(2), (std::vector<std::string>{row(0.0, 1.0, 2.0, kNear, -50.0),
                                               row(1.0, 1.0, 2.0, kNear, -51.0)}));
}

TEST_F(NodeletSessionTest, AClickPlacesTheNamedAccessPoint) {
  structure_from_wifi::AccessPointsConstPtr table;
  ros::NodeHandle node;
  const ros::Subscriber subscriber = node.subscribe<structure_from_wifi::AccessPoints>(
      name_ + "/access_points", 10,
      [&](const structure_from_wifi::AccessPointsConstPtr& message) { table = message; });
  const ros::Publisher clicks =
      node.advertise<geometry_msgs::PointStamped>(name_ + "/clicked_point", 10);
  load();
  ASSERT_TRUE(spinUntil([&] { return clicks.getNumSubscribers() > 0 && table; }, 10.0));
  geometry_msgs::PointStamped click;
  click.header.frame_id = "base_link";
  click.point.x = 1.0;
  clicks.publish(click);  // nobody named an access point: ignored
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  ros::param::set(name_ + "/mapping/clicked_point_bssid", kNear);
  clicks.publish(click);
  EXPECT_TRUE(spinUntil([&] { return table->access_points[0].position.x == 2.0; }, 20.0));
  EXPECT_EQ(table->access_points[0].position.y, 2.0);
}

TEST_F(NodeletSessionTest, AClearedRegionIsForgotten) {
  load();
  drive();
  ASSERT_TRUE(mapAppears());
  structure_from_wifi::ClearRegion call;
  ASSERT_TRUE(callService(name_ + "/mapping/clear_region", call));
  EXPECT_FALSE(call.response.success) << "neither polygon nor radius";
  call.request.radius = 100.0;
  ASSERT_TRUE(callService(name_ + "/mapping/clear_region", call));
  EXPECT_TRUE(call.response.success);
  EXPECT_EQ(call.response.readings, 120U);
  EXPECT_TRUE(spinUntil([&] { return freeCells() == 0; }, 20.0 * kSlowdown));
  EXPECT_FALSE(save("nothing").success);
}

TEST_F(NodeletSessionTest, AStandingRobotPublishesNoMap) {
  load();
  drive();
  ASSERT_TRUE(mapAppears());
  int maps = 0;
  const ros::Subscriber counter = ros::NodeHandle().subscribe<nav_msgs::OccupancyGrid>(
      name_ + "/map", 100, [&](const nav_msgs::OccupancyGridConstPtr&) { ++maps; });
  ASSERT_EQ(rows(120).size(), 120U);
  for (int i = 0; i < 100; ++i) {  // the first of these are news
    sendPose(4.0 + 0.05 * i, 2.95, 1.0);
    sendScan(4.0 + 0.05 * i, {{kNear, -50.0F}});
  }
  ASSERT_EQ(rows(220).size(), 220U);
  // Saving has made the map of all of them.
  ASSERT_TRUE(spinUntil([&] { return map_->data == servedMap().data; }, 10.0 * kSlowdown));
  const int before = maps;
  for (int i = 0; i < 100; ++i) {
    sendPose(10.0 + 0.05 * i, 2.95, 1.0);
    sendScan(10.0 + 0.05 * i, {{kNear, -50.0F}});
    spinUntil([&] { return maps > before; }, 0.02);
  }
  EXPECT_EQ(maps, before) << "readings at one place made a map";
  EXPECT_EQ(rows(320).size(), 320U) << "they are kept all the same";
}

TEST_F(NodeletSessionTest, UpdatesAddUpToTheMap) {
  ros::param::set(name_ + "/mapping/ros/map_updates", true);
  nav_msgs::OccupancyGrid costmap;
  int updates = 0;
  ros::NodeHandle node;
  const ros::Subscriber whole = node.subscribe<nav_msgs::OccupancyGrid>(
      name_ + "/map", 100, [&](const nav_msgs::OccupancyGridConstPtr& map) { costmap = *map; });
  const ros::Subscriber parts = node.subscribe<map_msgs::OccupancyGridUpdate>(
      name_ + "/map_updates", 100, [&](const map_msgs::OccupancyGridUpdateConstPtr& part) {
        ++updates;
        ASSERT_LE(static_cast<std::uint32_t>(part->x) + part->width, costmap.info.width);
        ASSERT_LE(static_cast<std::uint32_t>(part->y) + part->height, costmap.info.height);
        for (std::size_t i = 0; i < part->data.size(); ++i) {
          const std::size_t x = static_cast<std::size_t>(part->x) + i % part->width;
          const std::size_t y = static_cast<std::size_t>(part->y) + i / part->width;
          costmap.data[y * costmap.info.width + x] = part->data[i];
        }
      });
  load();
  ASSERT_TRUE(spinUntil([&] { return parts.getNumPublishers() > 0; }, 10.0));
  for (int leg = 0; leg < 3; ++leg) {
    drive(10.0 * leg, 1.0 + leg);
    ASSERT_EQ(rows(120U * static_cast<std::size_t>(leg + 1)).size(),
              120U * static_cast<std::size_t>(leg + 1));
  }
  EXPECT_TRUE(spinUntil([&] { return costmap.data == servedMap().data; }, 10.0 * kSlowdown));
  EXPECT_GT(updates, 0);
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_session_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
