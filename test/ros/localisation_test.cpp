// The topic ~localisation of the mapping nodelet.

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <array>
#include <cmath>
#include <string>

#include "mapping_nodelet_world.h"
#include "ros/mapping/scan_localisation.h"
#include "ros/service_call.h"

namespace sfw {
namespace {

class LocalisationTest : public NodeletWorld {
 protected:
  using Pose = geometry_msgs::PoseWithCovarianceStamped;

  static Readings heardAt(double x, double y) {
    constexpr std::array<std::array<double, 2>, 4> kRadios = {
        {{-1.0, -1.0}, {11.0, -1.0}, {-1.0, 7.0}, {11.0, 7.0}}};
    Readings readings;
    for (std::size_t i = 0; i < kRadios.size(); ++i) {
      const double distance = std::hypot(x - kRadios[i][0], y - kRadios[i][1], 1.0);
      readings.emplace_back("02:00:00:00:00:1" + std::to_string(i),
                            static_cast<float>(-35.0 - 30.0 * std::log10(distance)));
    }
    return readings;
  }

  void loadAt(double rate_hz) {
    ros::param::set(name_ + "/mapping/ros/localisation_rate", rate_hz);
    ros::param::set(name_ + "/mapping/ros/tf_cache", 1000.0);  // the drive is sent in no time
    load();
  }

  void listen() {
    subscriber_ = ros::NodeHandle().subscribe<Pose>(
        name_ + "/mapping/localisation", 100, [this](const Pose::ConstPtr& pose) { pose_ = pose; });
  }

  /// Lanes of 10 m in a room of 10 x 6 m.
  void map() {
    double time_s = 0.0;
    for (int lane = 0; lane <= 6; ++lane) {
      for (int step = 0; step <= 20; ++step, time_s += 0.5) {
        ros::Time::setNow(at(time_s));
        const double x = lane % 2 == 0 ? 0.5 * step : 10.0 - 0.5 * step;
        sendPose(time_s, x, lane);
        sendScan(time_s, heardAt(x, lane));
      }
    }
    // A later reading makes a map when the others are old enough.
    ASSERT_TRUE(spinUntil([&] { return map_ != nullptr; }, 10.0));
    ASSERT_GE(rows(588).size(), 588U);
    ros::Time::setNow(at(kLater));
    sendPose(kLater, 5.0, 6.5);
    sendScan(kLater, heardAt(5.0, 6.5));
  }

  /// Sends scans without a pose from one place until the nodelet tells a place near it.
  bool isFoundAt(double x, double y, double first_s, double timeout_s = 20.0) {
    double time_s = first_s;
    return spinUntil(
        [&] {
          time_s += 0.5;
          ros::Time::setNow(at(time_s));
          sendScan(time_s, heardAt(x, y));
          return pose_ && pose_->header.stamp >= at(first_s) &&
                 std::hypot(pose_->pose.pose.position.x - x, pose_->pose.pose.position.y - y) < 1.5;
        },
        timeout_s * kSlowdown);
  }

  static constexpr double kLater = 200.0;
  ros::Subscriber subscriber_;
  Pose::ConstPtr pose_;
};

TEST_F(LocalisationTest, IsOffByDefault) {
  load();
  EXPECT_FALSE(advertises(name_ + "/mapping/localisation"));
}

TEST_F(LocalisationTest, FindsARobotThatHasNoPose) {
  loadAt(20.0);
  listen();
  map();
  ASSERT_TRUE(isFoundAt(2.0, 3.0, 300.0));
  EXPECT_EQ(pose_->header.frame_id, "map");
  EXPECT_GT(pose_->pose.covariance[0], 0.0);
  EXPECT_GT(pose_->pose.covariance[7], 0.0);
  EXPECT_EQ(pose_->pose.covariance[1], pose_->pose.covariance[6]);
  EXPECT_GT(pose_->pose.covariance[35], 3.0) << "the yaw is unknown";
  ASSERT_TRUE(isFoundAt(9.0, 1.0, 800.0)) << "it was carried away";
}

TEST_F(LocalisationTest, GoesOnWhileTheMapIsPausedAndEndsWithAReset) {
  loadAt(20.0);
  listen();
  map();
  ASSERT_TRUE(isFoundAt(2.0, 3.0, 300.0));
  std_srvs::SetBool pause;
  pause.request.data = 1;
  ASSERT_TRUE(callService(name_ + "/mapping/pause", pause));
  ASSERT_TRUE(isFoundAt(8.0, 5.0, 800.0));
  std_srvs::Trigger reset;
  ASSERT_TRUE(callService(name_ + "/mapping/reset", reset));
  spinUntil([] { return false; }, 0.5);
  pose_ = nullptr;
  EXPECT_FALSE(isFoundAt(8.0, 5.0, 1200.0, 1.0)) << "there is no radio map";
}

TEST_F(LocalisationTest, UnloadsAtOnce) {
  loadAt(0.01);
  map();
  EXPECT_LT(secondsToUnload(), 2.0 * kSlowdown);
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "localisation_test");
  const ros::NodeHandle node;  // starts roscpp
  return RUN_ALL_TESTS();
}
