// The mapping nodelet in this process with a localisation that corrects the odometry on the way.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <structure_from_wifi/AccessPoints.h>

#include <cmath>
#include <limits>

#include "mapping_nodelet_world.h"

namespace sfw {
namespace {

class CorrectedPathTest : public NodeletWorld {
 protected:
  static constexpr int kSteps = 50;
  static constexpr double kStepWay = 0.1;  // [m], straight on in x
  static constexpr double kDrift = 0.04;   // to the left, in metres a metre

  /// tf of a localisation: odometry, and how far to the left its frame lies.
  void sendPoses(double seconds, double x, double y_in_odom, double odom_y) {
    tf2_msgs::TFMessage message;
    message.transforms = {transform(seconds, "map", "odom", 0.0, odom_y),
                          transform(seconds, "odom", "base_link", x, y_in_odom)};
    transforms_.publish(message);
  }

  /// Drives the whole way by odometry alone, a reading a step.
  void drive() {
    for (int i = 0; i < kSteps; ++i) {
      const double x = kStepWay * i;
      sendPoses(0.2 * i, x, kDrift * x, 0.0);
      sendScan(0.2 * i, {{kNear, -50.0F}});
    }
  }

  /// What the localisation says in the end: that the robot is on the x axis.
  void closeLoop() {
    const double x = kStepWay * kSteps;
    sendPoses(0.2 * kSteps, x, kDrift * x, -kDrift * x);
  }

  /// The largest distance of a saved reading from the x axis [m].
  double largestOffset(std::size_t readings) {
    const std::vector<std::string> saved = rows(readings);
    EXPECT_EQ(saved.size(), readings);
    double largest = 0.0;
    for (const std::string& row : saved) {
      std::istringstream fields(row);
      double stamp = 0.0, x = 0.0, y = 0.0;
      fields >> stamp >> x >> y;
      largest = std::max(largest, std::abs(y));
    }
    return largest;
  }
};

TEST_F(CorrectedPathTest, ALoopClosureTakesTheDriftOffWhatWasReadBefore) {
  load();
  drive();
  EXPECT_NEAR(largestOffset(kSteps), kDrift * kStepWay * (kSteps - 1), 1e-3);
  closeLoop();
  sendScan(0.2 * kSteps, {{kNear, -50.0F}});
  EXPECT_LT(largestOffset(kSteps + 1), 1e-3);
}

TEST_F(CorrectedPathTest, TheMapFollowsACorrectionThatComesWithoutAReading) {
  nav_msgs::PathConstPtr path;
  const ros::Subscriber subscriber = ros::NodeHandle().subscribe<nav_msgs::Path>(
      name_ + "/path", 10, [&](const nav_msgs::PathConstPtr& message) { path = message; });
  load();
  drive();
  const auto lastOffset = [&] {
    return path && path->poses.size() == kSteps ? path->poses.back().pose.position.y : -1.0;
  };
  EXPECT_TRUE(spinUntil([&] { return lastOffset() > 0.15; }, 20.0));
  closeLoop();
  EXPECT_TRUE(spinUntil([&] { return std::abs(lastOffset()) < 0.01; }, 20.0));
}

TEST_F(CorrectedPathTest, StaysWhereTfSaidIfTheOdometrysFrameIsTheMaps) {
  ros::param::set(name_ + "/mapping/ros/odom_frame", "map");
  load();
  drive();
  closeLoop();
  sendScan(0.2 * kSteps, {{kNear, -50.0F}});
  EXPECT_NEAR(largestOffset(kSteps + 1), kDrift * kStepWay * (kSteps - 1), 1e-3);
}

TEST_F(CorrectedPathTest, TellsOfTwoPublishersAndDoesNotTakeThemForLoopClosures) {
  std::string told;
  const ros::Subscriber diagnostics = ros::NodeHandle().subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
        for (const diagnostic_msgs::DiagnosticStatus& status : array->status) {
          told += status.name.find("transforms") != std::string::npos ? status.message : "";
        }
      });
  load();
  for (int i = 0; i < kSteps; ++i) {
    sendPoses(0.2 * i, kStepWay * i, 0.0, i % 2);
    sendScan(0.2 * i, {{kNear, -50.0F}});
  }
  std::size_t aside = 0;
  for (const std::string& row : rows(kSteps)) {
    std::istringstream fields(row);
    double stamp = 0.0, x = 0.0, y = 0.0;
    fields >> stamp >> x >> y;
    EXPECT_TRUE(y == 0.0 || y == 1.0) << "was moved to " << y;
    aside += y == 1.0 ? 1 : 0;
  }
  EXPECT_EQ(aside, kSteps / 2U);
  EXPECT_TRUE(spinUntil(
      [&] {
        return told.find("Two programs publish the transform from map to odom") !=
               std::string::npos;
      },
      10.0))
      << told;
}

TEST_F(CorrectedPathTest, PublishesTheAccessPoints) {
  structure_from_wifi::AccessPointsConstPtr published;
  load();
  drive();
  EXPECT_EQ(rows(kSteps).size(), static_cast<std::size_t>(kSteps));
  const ros::Subscriber late = ros::NodeHandle().subscribe<structure_from_wifi::AccessPoints>(
      name_ + "/access_points", 10,
      [&](const structure_from_wifi::AccessPointsConstPtr& message) { published = message; });
  ASSERT_TRUE(spinUntil([&] { return published != nullptr; }, 30.0)) << "is not latched";
  EXPECT_EQ(published->header.frame_id, "map");
  ASSERT_EQ(published->access_points.size(), 2U);
  const structure_from_wifi::AccessPoint& far = published->access_points[1];
  EXPECT_EQ(far.bssid, kFar);
  EXPECT_EQ(far.position.x, 4.0);
  EXPECT_EQ(far.position.y, 3.0);
  EXPECT_FALSE(far.estimated);
  EXPECT_EQ(far.readings, 0U);
  EXPECT_EQ(published->access_points[0].readings, static_cast<unsigned>(kSteps));
  for (const double covariance : far.covariance) {
    EXPECT_EQ(covariance, 0.0);
  }
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "corrected_path_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
