// What a loaded mapping nodelet tells its user: /diagnostics and the log.

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <std_msgs/String.h>

#include "nodelet_diagnostics_world.h"

namespace sfw {
namespace {

using NodeletDiagnosticsTest = NodeletDiagnosticsWorld;
using Level = diagnostic_msgs::DiagnosticStatus;

TEST_F(NodeletDiagnosticsTest, TellWhyThereIsNoMapAndThatThereIsOne) {
  load();
  EXPECT_TRUE(hears("map", Level::WARN, "no message has come on " + name_ + "/wifi_scan"));
  EXPECT_TRUE(hears("transforms", Level::ERROR, "base_link"));
  for (int i = 0; i < 60; ++i) {
    sendPose(0.05 * i, 0.05 * i, 1.0);
    sendScan(0.05 * i, {{kNear, -50.0F}, {kFar, -60.0F}});
  }
  EXPECT_TRUE(hears("map", Level::OK, "m2 of free space from 120 readings"));
  EXPECT_TRUE(hears("inputs", Level::OK, "Readings arrive"));
  EXPECT_TRUE(hears("transforms", Level::OK, "base_link to map"));
}

TEST_F(NodeletDiagnosticsTest, NameTheReasonForReadingsThatWait) {
  load();
  sendScan(0.0, {{kNear, -50.0F}});
  EXPECT_TRUE(hears("map", Level::WARN, "tf has no frame map, base_link"));
  ros::Time::setNow(at(60.0));
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN, "tf had no transform from base_link to map"));
  EXPECT_TRUE(hears("map", Level::WARN, "tf has no frame map, base_link"));
}

TEST_F(NodeletDiagnosticsTest, NameTheReasonForReadingsThatAreAllRefused) {
  load();
  sendPose(0.0, 1.0, 2.0);
  for (int i = 0; i < 5; ++i) {
    sendScan(0.0, {{kNear, 70.0F}});
  }
  EXPECT_TRUE(hears("map", Level::WARN, "5 readings are refused: rssi_dbm is not in (-120, 0]"));
  EXPECT_NE(save("nothing").message.find("readings are refused: rssi_dbm"), std::string::npos);
  EXPECT_EQ(logged(rosgraph_msgs::Log::INFO, "The first reading"), 0);
}

TEST_F(NodeletDiagnosticsTest, NameTheFrameOfContactsThatAreDropped) {
  ros::Publisher clouds =
      ros::NodeHandle().advertise<sensor_msgs::PointCloud2>(name_ + "/contact_points", 10);
  load();
  ASSERT_TRUE(spinUntil([&] { return clouds.getNumSubscribers() > 0; }, 30.0));
  sendPose(0.0, 1.0, 2.0);
  sendPose(60.0, 1.0, 2.0);
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "bumper_link";
  cloud.header.stamp = at(0.0);
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  clouds.publish(cloud);
  ros::Time::setNow(at(60.0));
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN,
                   "1 contacts dropped: tf had no transform from bumper_link to map"));
  EXPECT_TRUE(hasValue("transforms", "contacts dropped without a transform", "1"));
  EXPECT_EQ(logged(rosgraph_msgs::Log::WARN, "from base_link to map"), 0);
  EXPECT_TRUE(hears("map", Level::WARN, "no message has come on"));
}

TEST_F(NodeletDiagnosticsTest, ComeWhileTheClockStandsStillAtZero) {
  ros::Time::setNow(ros::Time());
  load();
  EXPECT_TRUE(hears("transforms", Level::ERROR, "no node publishes /clock"));
}

TEST_F(NodeletDiagnosticsTest, ComeFromANodeletWithBadParameters) {
  ros::param::set(name_ + "/bad/access_points", tableOf({{kNear, 0.0, 0.0}}));
  ros::param::set(name_ + "/bad/map/resolution", 0.0);
  ASSERT_TRUE(loader_.load(name_ + "/bad", "structure_from_wifi/MappingNodelet", {}, {}));
  EXPECT_TRUE(hears("map", Level::ERROR, "map/resolution", "bad"));
  EXPECT_TRUE(loader_.unload(name_ + "/bad"));
}

TEST_F(NodeletDiagnosticsTest, LogsOfTheFirstMinuteSayThatAllIsWell) {
  load();
  EXPECT_TRUE(logs(rosgraph_msgs::Log::INFO, "Mapping with 2 access points of the table, 0 of"));
  for (int i = 0; i < 60; ++i) {
    sendPose(0.05 * i, 0.05 * i, 1.0);
    sendScan(0.05 * i, {{kNear, -50.0F}, {"02:00:00:00:00:ff", -60.0F}});
  }
  EXPECT_TRUE(logs(rosgraph_msgs::Log::INFO, "The first reading, of 02:00:00:00:00:01"));
  EXPECT_TRUE(logs(rosgraph_msgs::Log::INFO, "The map covers"));
  EXPECT_TRUE(logs(rosgraph_msgs::Log::INFO, "Radios of neighbours are normal"));
  EXPECT_EQ(logged(rosgraph_msgs::Log::WARN, "bssid is not in the table"), 0);
}

TEST_F(NodeletDiagnosticsTest, NameTheTypeOfATopicThatBringsNoScans) {
  scans_.shutdown();
  scans_ = ros::NodeHandle().advertise<std_msgs::String>(name_ + "/wifi_scan", 10);
  load();
  for (int i = 0; i < 100; ++i) {
    scans_.publish(std_msgs::String());
  }
  EXPECT_TRUE(
      logs(rosgraph_msgs::Log::WARN, "wifi_scan: its messages are of type std_msgs/String"));
  EXPECT_EQ(logged(rosgraph_msgs::Log::WARN, "std_msgs/String"), 1);
  EXPECT_TRUE(hears("map", Level::WARN, "its messages are of type std_msgs/String"));
}

TEST_F(NodeletDiagnosticsTest, LogsTellClocksApartFromFrames) {
  load();
  sendPose(0.0, 1.0, 2.0);
  sendScan(-500.0, {{kNear, -50.0F}});
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN, "compare the clocks of the machines"));
  EXPECT_EQ(logged(rosgraph_msgs::Log::WARN, "correct ros/antenna_frame"), 0);
}

TEST_F(NodeletDiagnosticsTest, LogsTellEachCauseOnce) {
  load();
  sendPose(0.0, 1.0, 2.0);
  for (int i = 0; i < 100; ++i) {
    sendScan(0.0, {{kNear, 70.0F}});
    sendScan(0.0, {{"no address", -50.0F}});
  }
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1).size(), 1U);
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN, "100 readings rejected so far: rssi_dbm is not in"));
  EXPECT_TRUE(logs(rosgraph_msgs::Log::WARN, "a BSSID is malformed"));
  EXPECT_EQ(logged(rosgraph_msgs::Log::WARN, "a BSSID is malformed"), 1);
  EXPECT_LE(logged(rosgraph_msgs::Log::WARN, "rssi_dbm is not in"), 3);
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_diagnostics_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
