// Watches the simulator node of simulator.test drive from start to end.

#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Bool.h>
#include <structure_from_wifi/WifiScan.h>
#include <tf2_ros/transform_listener.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include "files/map_server.h"
#include "structure_from_wifi/readings_io.h"
#include "support/slowdown.h"

namespace sfw {
namespace {

using structure_from_wifi::ApReading;
using structure_from_wifi::WifiScan;

/// Handles messages until something becomes true or real time runs out.
bool spinUntil(const std::function<bool()>& done, double timeout_s) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout_s);
  while (!done() && ros::WallTime::now() < deadline) {
    ros::spinOnce();
    ros::WallDuration(0.002).sleep();
  }
  return done();
}

/// The name of a file in test/data.
std::string dataFile(const std::string& name) {
  std::string folder;
  ros::NodeHandle("~").getParam("data", folder);
  return folder + "/" + name;
}

/// One drive, watched from before its start to its end; the tests look at what came of it.
class Drive : public testing::Test {
 protected:
  struct Record {
    std::vector<ros::Time> clocks;
    std::vector<WifiScan> scans;
    std::vector<bool> finished;
    tf2_ros::Buffer transforms{ros::Duration(1000.0)};
    ros::Time last_clock_when_finished;
  };

  static void SetUpTestSuite() {
    record_ = std::make_unique<Record>();
    Record& record = *record_;
    const tf2_ros::TransformListener listener(record.transforms);
    ros::NodeHandle node;
    const auto clock = node.subscribe<rosgraph_msgs::Clock>(
        "/clock", 1000, [&](const rosgraph_msgs::ClockConstPtr& message) {
          record.clocks.push_back(message->clock);
        });
    const auto finished = node.subscribe<std_msgs::Bool>(
        "finished", 10,
        [&](const std_msgs::BoolConstPtr& message) { record.finished.push_back(message->data); });
    const auto scans = node.subscribe<WifiScan>(
        "wifi_scan", 1000, [&](const structure_from_wifi::WifiScanConstPtr& message) {
          record.scans.push_back(*message);
        });
    spinUntil([&] { return !record.finished.empty() && record.finished.back(); }, 30.0 * kSlowdown);
    const std::size_t clocks = record.clocks.size();
    spinUntil([&] { return record.clocks.size() > clocks + 20; }, 30.0 * kSlowdown);
  }

  static void TearDownTestSuite() { record_.reset(); }

  static std::unique_ptr<Record> record_;
};

std::unique_ptr<Drive::Record> Drive::record_;

TEST_F(Drive, TheClockRunsForwards) {
  ASSERT_GT(record_->clocks.size(), 100U);
  for (std::size_t i = 1; i < record_->clocks.size(); ++i) {
    EXPECT_LT(record_->clocks[i - 1], record_->clocks[i]);
  }
  // The route takes 10 s; the clock ran before it and after it.
  EXPECT_GT(record_->clocks.back() - record_->clocks.front(), ros::Duration(10.0));
}

TEST_F(Drive, FinishesOnce) { EXPECT_EQ(record_->finished, (std::vector<bool>{false, true})); }

TEST_F(Drive, ScansHearBothAccessPointsAtTheScanRate) {
  ASSERT_GT(record_->scans.size(), 40U);
  std::uint32_t sequence = record_->scans.front().header.seq;
  EXPECT_EQ(sequence, 0U) << "the first scan went to nobody";
  for (const WifiScan& scan : record_->scans) {
    EXPECT_EQ(scan.header.seq, sequence++);
    EXPECT_EQ(scan.header.frame_id, "base_link");
    ASSERT_EQ(scan.readings.size(), 2U);
    EXPECT_EQ(scan.readings[0].bssid, "02:00:00:00:00:01");
    EXPECT_EQ(scan.readings[0].ssid, "corner");
    for (const ApReading& reading : scan.readings) {
      EXPECT_GT(reading.rssi_dbm, -90.0F);
      EXPECT_LE(reading.rssi_dbm, 0.0F);
    }
  }
  for (std::size_t i = 1; i < record_->scans.size(); ++i) {
    const auto step = record_->scans[i].header.stamp - record_->scans[i - 1].header.stamp;
    EXPECT_NEAR(step.toSec(), 0.2, 1e-6);
  }
}

TEST_F(Drive, TheRobotsPoseIsKnownAtEveryScan) {
  const std::vector<Position> way_points = readWayPoints(dataFile("room_route.csv"));
  std::vector<Position> poses;
  for (const WifiScan& scan : record_->scans) {
    ASSERT_NO_THROW({
      const auto map_from_base =
          record_->transforms.lookupTransform("map", "base_link", scan.header.stamp);
      poses.emplace_back(map_from_base.transform.translation.x,
                         map_from_base.transform.translation.y);
    });
  }
  ASSERT_FALSE(poses.empty());
  EXPECT_NEAR((poses.front() - way_points.front()).norm(), 0.0, 1e-6);
  EXPECT_LT((poses.back() - way_points.back()).norm(), 0.11);  // within a scan's time of the end
}

TEST_F(Drive, TransformsFollowTheLastScanAndGoOn) {
  ASSERT_FALSE(record_->scans.empty());
  const ros::Time later = record_->scans.back().header.stamp + ros::Duration(0.5);
  EXPECT_TRUE(record_->transforms.canTransform("map", "base_link", later));
}

TEST_F(Drive, OdometryStartsWhereItIsTold) {
  const auto map_from_odom = record_->transforms.lookupTransform("map", "odom", ros::Time(0));
  EXPECT_NEAR(map_from_odom.transform.translation.x, 1.0, 1e-9);
  EXPECT_NEAR(map_from_odom.transform.translation.y, -2.5, 1e-9);
  EXPECT_NEAR(map_from_odom.transform.rotation.z, std::sin(0.25), 1e-9);
}

TEST(Simulator, TruthIsThePlanAndLatched) {
  ros::NodeHandle node;
  nav_msgs::OccupancyGridConstPtr truth;
  const auto subscriber = node.subscribe<nav_msgs::OccupancyGrid>(
      "truth", 1, [&](const nav_msgs::OccupancyGridConstPtr& message) { truth = message; });
  ASSERT_TRUE(spinUntil([&] { return truth != nullptr; }, 30.0));
  const Grid<CellState> plan = readMap(dataFile("room.yaml"));
  EXPECT_EQ(truth->header.frame_id, "map");
  EXPECT_EQ(truth->info.resolution, 0.1F);
  EXPECT_EQ(truth->info.origin.position.x, -1.0);
  EXPECT_EQ(truth->info.origin.position.y, -0.5);
  EXPECT_EQ(truth->info.origin.orientation.w, 1.0);
  ASSERT_EQ(truth->info.width, static_cast<std::uint32_t>(plan.geometry.width()));
  ASSERT_EQ(truth->info.height, static_cast<std::uint32_t>(plan.geometry.height()));
  ASSERT_EQ(truth->data.size(), plan.cells.size());
  const std::map<CellState, int> values = {
      {CellState::kUnknown, -1}, {CellState::kFree, 0}, {CellState::kOccupied, 100}};
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    ASSERT_EQ(truth->data[i], values.at(plan.cells[i])) << "cell " << i;
  }
}

/// Loads a second simulator into this process.
class SecondSimulator : public testing::Test {
 protected:
  void SetUp() override {
    ros::NodeHandle node("/second");
    node.setParam("plan", dataFile("room.yaml"));
    node.setParam("route", dataFile("room_route.csv"));
    XmlRpc::XmlRpcValue table;
    table[0]["bssid"] = "02:00:00:00:00:01";
    table[0]["x"] = 0;
    table[0]["y"] = 0.5;
    node.setParam("access_points", table);
    node.setParam("map_frame", "another_map");
    node.setParam("odom_frame", "another_odom");
    node.setParam("base_frame", "another_base");
  }

  void TearDown() override { ros::param::del("/second"); }

  bool load() {
    return loader_.load("/second", "structure_from_wifi/Simulator",
                        {{"truth", "/second/truth"},
                         {"wifi_scan", "/second/wifi_scan"},
                         {"finished", "/second/finished"}},
                        {});
  }

  static bool advertises(const std::string& topic) {
    ros::V_string topics;
    ros::this_node::getAdvertisedTopics(topics);
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
  }

  nodelet::Loader loader_{false};
};

TEST_F(SecondSimulator, UnloadsWithinASecond) {
  ASSERT_TRUE(load());
  EXPECT_TRUE(advertises("/second/truth"));
  const ros::WallTime start = ros::WallTime::now();
  EXPECT_TRUE(loader_.unload("/second"));
  EXPECT_LT((ros::WallTime::now() - start).toSec(), 1.0);
}

TEST_F(SecondSimulator, AdvertisesNothingWithABadParameter) {
  ros::param::set("/second/speed", "fast");
  ASSERT_TRUE(load());
  EXPECT_FALSE(advertises("/second/truth"));
  EXPECT_TRUE(loader_.unload("/second"));
}

TEST_F(SecondSimulator, AdvertisesNothingWithABlockedRoute) {
  ros::param::set("/second/robot_radius", 0.6);
  ASSERT_TRUE(load());
  EXPECT_FALSE(advertises("/second/truth"));
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "simulator_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
