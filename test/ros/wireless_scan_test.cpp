#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/master.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

namespace sfw {
namespace {

using diagnostic_msgs::DiagnosticStatus;

bool spinUntil(const std::function<bool()>& done) {
  const ros::SteadyTime deadline = ros::SteadyTime::now() + ros::WallDuration(60.0);
  while (!done() && ros::SteadyTime::now() < deadline) {
    ros::spinOnce();
    ros::WallDuration(0.01).sleep();
  }
  return done();
}

/// The next report of a node's radio.
std::optional<DiagnosticStatus> nextReport(const std::string& node) {
  std::optional<DiagnosticStatus> found;
  ros::NodeHandle handle;
  const auto subscriber = handle.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
        for (const DiagnosticStatus& status : array->status) {
          if (status.name == node + ": radio") {
            found = status;
          }
        }
      });
  spinUntil([&] { return found.has_value(); });
  return found;
}

// No machine has an adapter of the name that the launch file gives.

TEST(WirelessScan, SaysWhyItHearsNothingAndGoesOn) {
  const auto first = nextReport("wireless_scan");
  ASSERT_TRUE(first);
  EXPECT_EQ(first->level, DiagnosticStatus::ERROR);
  const bool names_the_fault =
      first->message.find("'sfw_none0' is no WiFi adapter") != std::string::npos ||
      first->message.find("No WiFi adapter is found") != std::string::npos ||
      first->message.find("The kernel has no nl80211") != std::string::npos;
  EXPECT_TRUE(names_the_fault) << first->message;
  EXPECT_TRUE(nextReport("wireless_scan")) << "it has to keep trying";
  EXPECT_TRUE(spinUntil([] {
    ros::master::V_TopicInfo topics;
    ros::master::getTopics(topics);
    for (const ros::master::TopicInfo& topic : topics) {
      if (topic.name == "/wifi_scan") {
        return topic.datatype == "structure_from_wifi/WifiScan";
      }
    }
    return false;
  }));
}

class LoadedNodelet : public testing::Test {
 protected:
  bool load(const std::string& mode, double rate_hz) {
    ros::param::set("/radio/mode", mode);
    ros::param::set("/radio/rate", rate_hz);
    return loader_.load("/radio", "structure_from_wifi/WirelessScanNodelet", {}, {});
  }

  static bool advertised() {
    ros::V_string topics;
    ros::this_node::getAdvertisedTopics(topics);
    return std::find(topics.begin(), topics.end(), "/wifi_scan") != topics.end();
  }

  nodelet::Loader loader_{false};
};

TEST_F(LoadedNodelet, LoadsAndUnloadsAgainAndAgain) {
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(load("scan", 20.0));
    EXPECT_TRUE(advertised());
    ASSERT_TRUE(loader_.unload("/radio"));
    EXPECT_FALSE(advertised());
  }
}

TEST_F(LoadedNodelet, AdvertisesNothingWithParametersThatCannotBeUsed) {
  std::string log;
  ros::NodeHandle handle;
  const auto subscriber = handle.subscribe<rosgraph_msgs::Log>(
      "/rosout", 100, [&](const rosgraph_msgs::LogConstPtr& line) { log += line->msg + "\n"; });
  ASSERT_TRUE(spinUntil([&] { return subscriber.getNumPublishers() > 0; }));
  EXPECT_TRUE(load("loud", 20.0));
  EXPECT_FALSE(advertised());
  const std::string problem = "mode must be link, cache or scan; it is 'loud'";
  EXPECT_TRUE(spinUntil([&] { return log.find(problem) != std::string::npos; })) << log;
  EXPECT_TRUE(loader_.unload("/radio"));
  EXPECT_TRUE(load("link", 1000.0));
  EXPECT_FALSE(advertised());
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "wireless_scan_test");
  const ros::NodeHandle keeps_ros_up;
  return RUN_ALL_TESTS();
}
