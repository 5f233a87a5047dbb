// A client of dynamic_reconfigure changes a loaded mapping nodelet.

#include <dynamic_reconfigure/client.h>
#include <gtest/gtest.h>
#include <structure_from_wifi/LiveConfig.h>

#include <limits>
#include <memory>

#include "nodelet_diagnostics_world.h"

namespace sfw {
namespace {

using structure_from_wifi::LiveConfig;

class NodeletReconfigureTest : public NodeletDiagnosticsWorld {
 protected:
  /// Loads the nodelet and waits for the settings that it tells its clients.
  void loadWithClient() {
    load();
    bool came = false;
    client_ = std::make_unique<dynamic_reconfigure::Client<LiveConfig>>(
        name_ + "/mapping/live", [this, &came](const LiveConfig& live) {
          live_ = live;
          came = true;
        });
    ASSERT_TRUE(spinUntil([&] { return came; }, 10.0));
    client_->setConfigurationCallback({});
  }

  /// Waits for the first map, and sends a reading that is worth a second one.
  /// @return how many grids came before it; 0 if no map came
  std::ptrdiff_t mapAndSendNews() {
    sendPose(0.0, 1.0, 2.0);
    sendScan(0.0, {{kNear, -50.0F}});
    spinUntil([&] { return cells(0) > 0; }, 30.0 * kSlowdown);
    const std::ptrdiff_t first = cells(0);
    sendPose(1.0, 1.5, 2.0);
    sendScan(1.0, {{kNear, -50.0F}});
    return first;
  }

  void driveAlong() {
    drive(0.0);
    ASSERT_EQ(rows(kScans).size(), static_cast<std::size_t>(kScans));
  }

  std::ptrdiff_t cells(int state) const {
    return map_ ? std::count(map_->data.begin(), map_->data.end(), state) : 0;
  }

  /// Asks for other settings; live_ is what holds then.
  void ask(LiveConfig wanted) {
    ASSERT_TRUE(client_->setConfiguration(wanted));
    live_ = wanted;
  }

  template <class T>
  T parameter(const std::string& name) const {
    T value{};
    EXPECT_TRUE(ros::param::get(name_ + "/mapping/" + name, value)) << name;
    return value;
  }

  std::unique_ptr<dynamic_reconfigure::Client<LiveConfig>> client_;
  LiveConfig live_;
};

TEST_F(NodeletReconfigureTest, StartsWithTheSettingsOfTheNodelet) {
  ros::param::set(name_ + "/mapping/belief/free_threshold", 0.11);
  ros::param::set(name_ + "/mapping/live/free_threshold", 0.3);  // of an earlier node
  loadWithClient();
  EXPECT_EQ(live_.free_threshold, 0.11);
  EXPECT_EQ(live_.publish_rate, 20.0);
  EXPECT_EQ(live_.rim, "unknown");
  EXPECT_EQ(live_.window, 5);
}

TEST_F(NodeletReconfigureTest, AChangedValueMakesAnotherMapOfTheSameReadings) {
  loadWithClient();
  driveAlong();
  ASSERT_TRUE(spinUntil([&] { return cells(0) > 0; }, 30.0 * kSlowdown));
  EXPECT_EQ(cells(100), 0);
  LiveConfig wanted = live_;
  wanted.rim = "occupied";
  ask(wanted);
  EXPECT_EQ(live_.rim, "occupied");
  EXPECT_TRUE(spinUntil([&] { return cells(100) > 0; }, 30.0 * kSlowdown));
  EXPECT_EQ(parameter<std::string>("belief/rim"), "occupied");
  EXPECT_EQ(parameter<std::string>("live/rim"), "occupied");
  EXPECT_TRUE(logs(rosgraph_msgs::Log::INFO, "belief/rim is occupied now"));
}

TEST_F(NodeletReconfigureTest, ValuesBeyondTheirLimitsAreRefusedTogether) {
  loadWithClient();
  const auto refuse = [&](const char* problem, const std::function<void(LiveConfig&)>& change) {
    LiveConfig wanted = live_;
    wanted.autosave_period = 7.0;  // by itself a good one
    change(wanted);
    ask(wanted);
    EXPECT_TRUE(logs(rosgraph_msgs::Log::ERROR, problem)) << problem;
    EXPECT_EQ(live_.autosave_period, 60.0) << problem;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuse("ros/publish_rate must be", [](LiveConfig& live) { live.publish_rate = 0.0; });
  refuse("ros/publish_rate must be", [&](LiveConfig& live) { live.publish_rate = nan; });
  refuse("belief/free_threshold must be", [](LiveConfig& live) { live.free_threshold = 0.64; });
  refuse("belief/occupied_threshold must be",
         [](LiveConfig& live) { live.occupied_threshold = 1.0; });
  refuse("belief/rim must be", [](LiveConfig& live) { live.rim = "round"; });
  refuse("k_visibility/window must be", [](LiveConfig& live) { live.window = 4; });
  EXPECT_EQ(live_.publish_rate, 20.0);
  EXPECT_EQ(live_.window, 5);
  EXPECT_EQ(parameter<double>("ros/publish_rate"), 20.0);
  driveAlong();
  EXPECT_TRUE(spinUntil([&] { return cells(0) > 0; }, 30.0 * kSlowdown));
}

TEST_F(NodeletReconfigureTest, TheRateOfMapsFollows) {
  ros::param::set(name_ + "/mapping/ros/publish_rate", 0.001);
  ros::param::set(name_ + "/mapping/ros/autosave_period", 0.0);
  loadWithClient();
  const std::ptrdiff_t first = mapAndSendNews();
  ASSERT_GT(first, 0);
  EXPECT_TRUE(hasValue("map", "readings", "2"));
  EXPECT_EQ(cells(0), first) << "the next one is due in a quarter of an hour";
  LiveConfig wanted = live_;
  wanted.publish_rate = 20.0;
  ask(wanted);
  EXPECT_TRUE(spinUntil([&] { return cells(0) > first; }, 30.0 * kSlowdown));
  EXPECT_EQ(parameter<double>("ros/publish_rate"), 20.0);
}

TEST_F(NodeletReconfigureTest, TheShareOfACoreFollows) {
  ros::param::set(name_ + "/mapping/ros/cpu_share", 0.01);
  ros::param::set(name_ + "/mapping/ros/autosave_period", 0.0);
  loadWithClient();
  const std::ptrdiff_t first = mapAndSendNews();
  ASSERT_GT(first, 0);
  EXPECT_FALSE(spinUntil([&] { return cells(0) > first; }, 0.3))
      << "after some 10 ms of CPU time, the next map is due in a second";
  LiveConfig wanted = live_;
  wanted.cpu_share = 2.0;
  ask(wanted);
  EXPECT_TRUE(logs(rosgraph_msgs::Log::ERROR, "ros/cpu_share must"));
  EXPECT_EQ(live_.cpu_share, 0.01);
  wanted.cpu_share = 1.0;
  ask(wanted);
  EXPECT_TRUE(spinUntil([&] { return cells(0) > first; }, 30.0 * kSlowdown));
  EXPECT_EQ(parameter<double>("ros/cpu_share"), 1.0);
}

TEST_F(NodeletReconfigureTest, ANodeThatStartsAgainKeepsWhatWasChanged) {
  loadWithClient();
  LiveConfig wanted = live_;
  wanted.free_threshold = 0.3;
  ask(wanted);
  client_.reset();
  secondsToUnload();
  loadWithClient();
  EXPECT_EQ(live_.free_threshold, 0.3);
  EXPECT_EQ(logged(rosgraph_msgs::Log::WARN, "is not a setting"), 0);
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_reconfigure_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
