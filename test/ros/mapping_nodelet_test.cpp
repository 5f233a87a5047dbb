// The mapping nodelet in this process, loaded as a manager loads it, under a simulated clock that
// only this test moves. What it took in is read from the readings.csv of ~save_map.

#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "any_message_of.h"
#include "mapping_nodelet_world.h"
#include "ros/conversion/input_messages.h"
#include "support/slowdown.h"

namespace sfw {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

using Rows = std::vector<std::string>;
using MappingNodeletTest = NodeletWorld;

TEST_F(MappingNodeletTest, PublishesAnUnknownMapBeforeTheClockRuns) {
  ros::Time::setNow(ros::Time());
  load();
  ASSERT_TRUE(spinUntil([&] { return map_ != nullptr; }, 30.0));
  EXPECT_EQ(std::count(map_->data.begin(), map_->data.end(), -1),
            static_cast<std::ptrdiff_t>(map_->data.size()));
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kNear, -50.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kNear, -50.0)});
}

TEST_F(MappingNodeletTest, UnloadsWithinASecondInTraffic) {
  load();
  std::atomic<bool> done{false};
  std::thread traffic([&] {
    for (int i = 0; !done; ++i) {
      sendPose(0.01 * i, 0.001 * i, 0.0);
      sendScan(0.01 * i, {{kNear, -50.0F - static_cast<float>(i % 20)}, {kFar, -60.0F}});
      ros::WallDuration(0.001).sleep();
    }
  });
  ros::WallDuration(0.3).sleep();
  EXPECT_LT(secondsToUnload(), 1.0);
  done = true;
  traffic.join();
}

TEST_F(MappingNodeletTest, UnloadsWithinASecondWhileTheClockStandsStill) {
  load();
  for (int i = 0; i < 100; ++i) {
    sendScan(i, {{kNear, -50.0F}});  // all wait for a transform
  }
  ros::WallDuration(0.2).sleep();
  EXPECT_LT(secondsToUnload(), 1.0);
}

TEST_F(MappingNodeletTest, DropsWhatIsNoSignal) {
  load();
  sendPose(0.0, 1.0, 2.0);
  for (const float rssi_dbm : {kNan, kInfinity, -kInfinity, 0.5F, 70.0F, -120.0F, -1e30F}) {
    sendScan(0.0, {{kNear, rssi_dbm}});
  }
  for (const char* bssid : {"", "02:00:00:00:00", "02:00:00:00:00:0g", "02:00:00:00:00:01:02"}) {
    sendScan(0.0, {{bssid, -50.0F}});
  }
  sendScan(0.0, {});
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(MappingNodeletTest, DropsAgesThatCannotBe) {
  load();
  sendPose(0.0, 1.0, 2.0);
  for (const float age_s : {kNan, kInfinity, -1.0F, 1e9F, 3e9F, 1e30F}) {
    sendScan(0.0, {{kNear, -50.0F}}, age_s);
    structure_from_wifi::WifiScan scan = scanOf({{kNear, -50.0F}}, age_s);
    scan.header.stamp = ros::Time(4e9);
    scans_.publish(scan);
  }
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(MappingNodeletTest, NormalisesAddressesAndKeepsStrangersForThePath) {
  load();
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{"02-00-00-00-00-01", -50.0F}, {"02:00:00:00:00:FF", -70.0F}});
  EXPECT_EQ(rows(2), (Rows{row(0.0, 1.0, 2.0, kNear, -50.0),
                           row(0.0, 1.0, 2.0, "02:00:00:00:00:ff", -70.0)}));
}

TEST_F(MappingNodeletTest, TheStrongestOfARadioNamedTwiceCounts) {
  load();
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kNear, -55.0F}, {kNear, -50.0F}, {kNear, -60.0F}});
  sendScan(0.0, {{kNear, -52.0F}});  // the same cached scan again
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(2), (Rows{row(0.0, 1.0, 2.0, kNear, -50.0), row(0.0, 1.0, 2.0, kFar, -60.0)}));
}

TEST_F(MappingNodeletTest, AHugeScanIsCapped) {
  std::vector<std::pair<std::string, float>> readings;
  for (int i = 0; i < 12000; ++i) {
    char bssid[18];
    std::snprintf(bssid, sizeof(bssid), "02:00:00:00:%02x:%02x", i / 256, i % 256);
    readings.emplace_back(bssid, -50.0F);
  }
  load();
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, readings);
  EXPECT_EQ(rows(kMostReadings).size(), kMostReadings) << "more than may wait, in one message";

  const AnyMessage message = anyMessageOf(scanOf(readings));
  Conversion conversion;
  ros::WallDuration least(1.0);
  for (int i = 0; i < 10; ++i) {
    const ros::WallTime begin = ros::WallTime::now();
    conversion = convertReadings(message, {at(0.0), "base_link", 0.15});
    least = std::min(least, ros::WallTime::now() - begin);  // a busy machine only adds to it
  }
  EXPECT_LT(least.toSec(), 0.05 * kSlowdown) << "the callback must not hold up others";
  EXPECT_EQ(conversion.observations.size(), kMostReadings);
  EXPECT_EQ(conversion.rejected.at("the message has more than 10000 readings"), 2000U);
}

TEST_F(MappingNodeletTest, WithoutAStampTheTimeOfReceiptCounts) {
  load();
  ros::Time::setNow(at(3.0));
  sendPose(2.0, 0.0, 0.0);
  sendPose(4.0, 2.0, 0.0);
  structure_from_wifi::WifiScan scan = scanOf({{kNear, -50.0F}});
  scan.header.stamp = ros::Time();
  scans_.publish(scan);
  EXPECT_EQ(rows(1), Rows{row(3.0, 1.0, 0.0, kNear, -50.0)});
}

TEST_F(MappingNodeletTest, AFarFutureTakesNothingElseWithIt) {
  load();
  structure_from_wifi::WifiScan scan = scanOf({{kNear, -50.0F}});
  scan.header.stamp = ros::Time(4e9);
  scans_.publish(scan);
  sendScan(1.0, {{kNear, -51.0F}});  // waits behind it
  sendPose(0.0, 1.0, 2.0);           // tf compares both with this one
  ros::WallDuration(0.2).sleep();
  sendPose(1.0, 1.0, 2.0);
  EXPECT_EQ(rows(1), Rows{row(1.0, 1.0, 2.0, kNear, -51.0)});
}

TEST_F(MappingNodeletTest, AFutureScanWaitsNoLongerThanAnyOther) {
  load();
  sendScan(3.0, {{kNear, -50.0F}});
  ros::WallDuration(0.1).sleep();
  ros::Time::setNow(at(6.0));  // 3 s after its stamp, but it has waited for 6 s
  ros::WallDuration(0.1).sleep();
  sendPose(3.0, 1.0, 2.0);
  sendPose(6.0, 1.0, 2.0);
  sendScan(6.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(6.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(MappingNodeletTest, AncientScansAreDropped) {
  load();
  sendPose(0.0, 1.0, 2.0);
  sendScan(-500.0, {{kNear, -50.0F}});
  ros::WallDuration(0.1).sleep();
  sendPose(-500.0, 5.0, 5.0);
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(MappingNodeletTest, AFrameThatNeverComesHoldsNothingUp) {
  load();
  for (int i = 0; i < 3000; ++i) {  // more than may wait
    sendScan(0.001 * i, {{kNear, -50.0F}});
  }
  EXPECT_EQ(rows(0), Rows{});
  ros::Time::setNow(at(60.0));
  sendPose(60.0, 1.0, 2.0);
  sendScan(60.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(60.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(MappingNodeletTest, LateTransformsLoseNothing) {
  load();
  constexpr int kScans = 40;
  constexpr int kLate = 4;  // scans, 0.05 s apart
  for (int i = 0; i < kScans + kLate; ++i) {
    ros::Time::setNow(at(0.05 * i));
    if (i < kScans) {
      sendScan(0.05 * i, {{kNear, -50.0F}, {kFar, -60.0F}});
    }
    if (i >= kLate) {
      sendPose(0.05 * (i - kLate), 0.05 * (i - kLate), 0.0);
    }
    ros::WallDuration(0.005).sleep();
  }
  EXPECT_EQ(rows(2 * kScans).size(), static_cast<std::size_t>(2 * kScans));
}

TEST_F(MappingNodeletTest, OrderDoesNotMatter) {
  std::vector<std::string> maps;
  for (const bool sorted : {true, false}) {
    load();
    constexpr int kScans = 60;
    for (int i = 0; i < kScans; ++i) {
      sendPose(0.05 * i, 0.1 * i, 1.0);
    }
    for (int i = 0; i < kScans; ++i) {
      const int j = sorted ? i : (7 * i) % kScans;
      sendScan(0.05 * j, {{kNear, j < 30 ? -40.0F : -55.0F}, {kFar, j < 20 ? -62.0F : -45.0F}});
    }
    ASSERT_EQ(rows(2 * kScans).size(), static_cast<std::size_t>(2 * kScans));
    maps.push_back(savedFile("map.pgm"));
    secondsToUnload();
  }
  EXPECT_FALSE(maps[0].empty());
  EXPECT_EQ(maps[0], maps[1]);
}

TEST_F(MappingNodeletTest, SurvivesContactsWithoutCoordinates) {
  load();
  ros::Publisher clouds =
      ros::NodeHandle().advertise<sensor_msgs::PointCloud2>(name_ + "/contact_points", 10);
  ASSERT_TRUE(spinUntil([&] { return clouds.getNumSubscribers() > 0; }, 30.0));
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "/base_link";
  cloud.width = cloud.height = 1000;
  clouds.publish(cloud);
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
}

TEST_F(MappingNodeletTest, BadParametersLeaveItInertAndItsSiblingAtWork) {
  load();
  const std::string bad = name_ + "/bad";
  for (const auto& [key, value] : std::vector<std::pair<std::string, XmlRpc::XmlRpcValue>>{
           {"map/resolution", 0},
           {"map/resolution", "fine"},
           {"access_points", 7},
           {"ros/antenna_frame", ""},
           {"access_points", tableOf({{kNear, 0.0, 0.0}, {kFar, 9e5, 9e5}})}}) {
    ros::param::set(bad + "/m/access_points", tableOf({{kNear, 0.0, 0.0}}));
    ros::param::set(bad + "/m/" + key, value);
    ASSERT_TRUE(loader_.load(bad + "/m", "structure_from_wifi/MappingNodelet", {}, {}));
    EXPECT_FALSE(advertises(bad + "/map")) << key;
    EXPECT_FALSE(ros::service::exists(bad + "/m/save_map", false)) << key;
    EXPECT_TRUE(loader_.unload(bad + "/m"));
    ros::param::del(bad);
  }
  sendPose(0.0, 1.0, 2.0);
  sendScan(0.0, {{kFar, -60.0F}});
  EXPECT_EQ(rows(1), Rows{row(0.0, 1.0, 2.0, kFar, -60.0)});
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "mapping_nodelet_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
