// Faults of the world around a loaded mapping nodelet: its clock, transforms and disk.

#include <gtest/gtest.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nodelet_diagnostics_world.h"
#include "small_disk.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

class NodeletFaultsTest : public NodeletDiagnosticsWorld {
 protected:
  using Rows = std::vector<std::string>;
  static constexpr int kWarn = rosgraph_msgs::Log::WARN;

  Rows sortedRows(std::size_t expected) {
    Rows saved = rows(expected);
    std::sort(saved.begin(), saved.end());
    return saved;
  }

  void sendTransform(double seconds, const geometry_msgs::Transform& transform) {
    tf2_msgs::TFMessage message;
    message.transforms.resize(1);
    message.transforms[0].header.stamp = at(seconds);
    message.transforms[0].header.frame_id = "map";
    message.transforms[0].child_frame_id = "base_link";
    message.transforms[0].transform = transform;
    transforms_.publish(message);
  }

  /// A pose whose x axis points down by an angle.
  static geometry_msgs::Transform tilted(double x, double angle_rad) {
    geometry_msgs::Transform transform;
    transform.translation.x = x;
    transform.translation.y = 2.0;
    transform.translation.z = 0.5;
    transform.rotation.y = std::sin(angle_rad / 2.0);
    transform.rotation.w = std::cos(angle_rad / 2.0);
    return transform;
  }
};

TEST_F(NodeletFaultsTest, AClockThatJumpsBackKeepsTheMapAndDropsWhatWaits) {
  load();
  ros::Time::setNow(at(100.0));
  sendPose(100.0, 1.0, 2.0);
  sendScan(100.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  sendScan(100.5, {{kFar, -60.0F}});  // waits for its transform
  EXPECT_TRUE(hears("map", diagnostic_msgs::DiagnosticStatus::OK, "from 1 readings"));
  ros::Time::setNow(at(0.0));
  EXPECT_TRUE(logs(kWarn, "the map is kept"));
  drive(0.0);
  ASSERT_EQ(rows(kScans + 1).size(), static_cast<std::size_t>(kScans + 1));
  EXPECT_TRUE(mapAppears()) << "publishing goes on";
  sendPose(100.5, 1.0, 2.0);
  sendScan(100.5, {{kNear, -52.0F}});
  const Rows all = rows(kScans + 2);
  EXPECT_EQ(all.size(), static_cast<std::size_t>(kScans + 2));
  EXPECT_EQ(std::count(all.begin(), all.end(), row(100.5, 1.0, 2.0, kFar, -60.0)), 0);
}

TEST_F(NodeletFaultsTest, AClockThatJumpsBackResetsTheMapIfAsked) {
  ros::param::set(name_ + "/mapping/ros/on_time_jump", "reset");
  load();
  ros::Time::setNow(at(100.0));
  sendPose(100.0, 1.0, 2.0);
  sendScan(100.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  ros::Time::setNow(at(0.0));
  EXPECT_TRUE(logs(kWarn, "the map is reset"));
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
  drive(1.0);
  EXPECT_TRUE(mapAppears()) << "publishing goes on";
}

TEST_F(NodeletFaultsTest, EmptyScansChangeNothingAndAreNamed) {
  load();
  sendPose(0.0, 1.0, 2.0);
  for (int i = 0; i < 10; ++i) {
    sendScan(0.1 * i, {});
  }
  EXPECT_TRUE(hears("map", diagnostic_msgs::DiagnosticStatus::WARN, "its scans are empty"));
  EXPECT_FALSE(save("nothing").success);
}

TEST_F(NodeletFaultsTest, TransformsThatAreNoneGiveNoPosition) {
  load();
  geometry_msgs::Transform broken = tilted(1.0, 0.0);
  broken.translation.x = std::numeric_limits<double>::quiet_NaN();
  sendTransform(0.0, broken);
  broken = tilted(1.0, 0.0);
  broken.rotation.w = 0.0;  // has no length
  sendTransform(1.0, broken);
  broken.rotation.w = 2.0;
  sendTransform(2.0, broken);
  broken.rotation.w = std::numeric_limits<double>::quiet_NaN();
  sendTransform(3.0, broken);
  for (const double seconds : {0.0, 1.0, 2.0, 3.0}) {
    sendScan(seconds, {{kNear, -50.0F}});
  }
  EXPECT_TRUE(hears("map", diagnostic_msgs::DiagnosticStatus::WARN, "tf has no frame"));
  ros::Time::setNow(at(60.0));
  EXPECT_TRUE(logs(kWarn, "4 readings dropped: tf had no transform"));
  sendPose(60.0, 1.0, 2.0);
  sendScan(60.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(60.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(NodeletFaultsTest, AnInfiniteTransformSpoilsNoOthers) {
  load();
  sendPose(0.0, 1.0, 2.0);
  geometry_msgs::Transform broken = tilted(1.0, 0.0);
  broken.translation.x = std::numeric_limits<double>::infinity();
  sendTransform(1.0, broken);
  sendPose(2.0, 2.0, 2.0);
  for (const double seconds : {0.5, 1.0, 1.5}) {
    sendScan(seconds, {{kNear, -50.0F}});
  }
  EXPECT_EQ(rows(3), (Rows{row(0.5, 1.25, 2.0, kNear, -50.0), row(1.0, 1.5, 2.0, kNear, -50.0),
                           row(1.5, 1.75, 2.0, kNear, -50.0)}));
  EXPECT_TRUE(logs(kWarn, "1 transforms on /tf are not finite and left out"));
  EXPECT_TRUE(hasValue("transforms", "transforms left out because they are not finite", "1"));
}

TEST_F(NodeletFaultsTest, ATiltedRobotIsProjectedAndTold) {
  load();
  sendTransform(0.0, tilted(1.0, 0.0));
  sendScan(0.0, {{kNear, -50.0F}});
  ASSERT_EQ(rows(1).size(), 1U);
  EXPECT_EQ(logged(kWarn, "The antenna tilted"), 0);
  sendTransform(1.0, tilted(1.5, 0.5236));
  sendScan(1.0, {{kNear, -51.0F}});
  EXPECT_EQ(rows(2), (Rows{row(0.0, 1.0, 2.0, kNear, -50.0), row(1.0, 1.5, 2.0, kNear, -51.0)}));
  EXPECT_TRUE(logs(kWarn, "The antenna tilted by up to 30 degrees at 1 readings"));
  EXPECT_TRUE(hasValue("transforms", "readings with a tilted antenna", "1"));
}

TEST_F(NodeletFaultsTest, AJumpOfThePoseIsDroppedIfAsked) {
  ros::param::set(name_ + "/mapping/ros/max_speed", 1.0);
  load();
  for (int i = 0; i < 3; ++i) {
    sendPose(i, i == 1 ? 50.0 : 1.0, 2.0);
    sendScan(i, {{kNear, -50.0F}});
  }
  EXPECT_EQ(rows(2), (Rows{row(0.0, 1.0, 2.0, kNear, -50.0), row(2.0, 1.0, 2.0, kNear, -50.0)}));
  EXPECT_TRUE(logs(kWarn, "1 readings dropped: their pose is farther away than ros/max_speed"));
  EXPECT_TRUE(hasValue("transforms", "readings dropped because their pose jumped", "1"));
}

TEST_F(NodeletFaultsTest, AJumpOfThePoseIsCountedAsStray) {
  load();
  for (int i = 0; i < kScans; ++i) {
    sendPose(0.05 * i, i == 30 ? 50.0 : 0.05 * i, 2.0);
    sendScan(0.05 * i, {{kNear, -50.0F}});
  }
  EXPECT_EQ(rows(kScans).size(), static_cast<std::size_t>(kScans)) << "the recording keeps it";
  EXPECT_TRUE(hasValue("map", "stray poses", "1"));
  ASSERT_TRUE(mapAppears());
  EXPECT_LT(map_->info.width, 600U) << "the map does not reach there";
}

TEST_F(NodeletFaultsTest, FramesWithALeadingSlashAreUnderstood) {
  ros::param::set(name_ + "/mapping/ros/map_frame", "/map");
  ros::param::set(name_ + "/mapping/ros/antenna_frame", "/base_link");
  load();
  EXPECT_TRUE(logs(kWarn, "'/base_link' is taken as 'base_link'"));
  ros::Publisher clouds =
      ros::NodeHandle().advertise<sensor_msgs::PointCloud2>(name_ + "/contact_points", 10);
  ASSERT_TRUE(spinUntil([&] { return clouds.getNumSubscribers() > 0; }, 30.0));
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "/base_link";
  cloud.header.stamp = at(0.0);
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(1);
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
  x[0] = 0.25F;
  x[1] = x[2] = 0.0F;
  sendPose(0.0, 1.0, 2.0);
  clouds.publish(cloud);
  EXPECT_TRUE(logs(kWarn, "contact_points: frames of tf2 have no leading slash"));
  structure_from_wifi::WifiScan scan = scanOf({{kNear, -50.0F}});
  scan.header.frame_id = "/base_link";
  scan.header.stamp = at(0.0);
  scans_.publish(scan);
  EXPECT_TRUE(logs(kWarn, "wifi_scan: frames of tf2 have no leading slash"));
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kNear, -50.0)});
  std::string contacts;
  EXPECT_TRUE(spinUntil(
      [&] {
        contacts = savedFile("contacts.csv");
        return contacts.find(",1.25") != std::string::npos;
      },
      10.0))
      << contacts;
}

TEST_F(NodeletFaultsTest, ASecondMapperOnTheSameTopicIsTold) {
  load();
  EXPECT_EQ(logged(kWarn, "is published by"), 0);
  const std::string second = name_ + "/second";
  ros::param::set(second + "/access_points", tableOf({{kNear, 0.0, 0.0}}));
  ASSERT_TRUE(loader_.load(second, "structure_from_wifi/MappingNodelet", {}, {}));
  EXPECT_TRUE(logs(kWarn, name_ + "/map is published by"));
  EXPECT_TRUE(loader_.unload(second));
}

TEST_F(NodeletFaultsTest, AFullDiskFailsWithTheReasonAndKeepsWhatWasSaved) {
  const SmallDisk disk(folder_, 8U << 20U);
  if (!disk.isMounted()) {
    GTEST_SKIP() << "only root may mount a small disk";
  }
  load();
  drive(0.0);
  ASSERT_EQ(rows(kScans).size(), static_cast<std::size_t>(kScans));
  const auto saved = contentOf(folder_ / "saved");
  ASSERT_FALSE(saved.empty());
  disk.fill();
  drive(10.0);
  const auto response = save("saved");
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find(folder_.string()), std::string::npos) << response.message;
  EXPECT_EQ(contentOf(folder_ / "saved"), saved);
  EXPECT_FALSE(save("another").success);
  disk.clear();
  EXPECT_EQ(rows(2 * kScans).size(), static_cast<std::size_t>(2 * kScans));
  disk.fill();
  EXPECT_LT(secondsToUnload(), 1.0) << "the autosave fails";
  EXPECT_TRUE(logs(kWarn, "The session could not be saved"));
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_faults_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
