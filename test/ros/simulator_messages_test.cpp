#include "ros/simulator/simulator_messages.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ros/conversion/message_conversion.h"

namespace sfw {
namespace {

const std::vector<Position> kWayPoints{{1, 1}, {9, 1}, {9, 6}};

SimulatorConfig configWith(double registration_error, double drift) {
  SimulatorConfig config;
  config.odom = {2.0, -1.0, 0.7};
  config.signals.registration_error_m = registration_error;
  config.signals.drift = drift;
  return config;
}

Eigen::Isometry2d transformOf(const geometry_msgs::TransformStamped& message) {
  const auto& transform = message.transform;
  Eigen::Isometry2d isometry = Eigen::Isometry2d::Identity();
  isometry.translate(Position(transform.translation.x, transform.translation.y));
  isometry.rotate(2.0 * std::atan2(transform.rotation.z, transform.rotation.w));
  return isometry;
}

std::vector<geometry_msgs::TransformStamped> messagesAt(const SimulatorConfig& config,
                                                        double time_s) {
  const Route route(kWayPoints, config.robot.max_speed_m_s, config.robot.max_yaw_rate_rad_s);
  return transformMessages(config, PositionError(config.signals), ros::Time(7.0),
                           route.poseAt(time_s), route.drivenAt(time_s));
}

TEST(SimulatorTransforms, ChainTheFrames) {
  const auto messages = messagesAt(configWith(0.0, 0.0), 3.0);
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].header.frame_id, "map");
  EXPECT_EQ(messages[0].child_frame_id, "odom");
  EXPECT_EQ(messages[1].header.frame_id, "odom");
  EXPECT_EQ(messages[1].child_frame_id, "base_link");
  EXPECT_EQ(messages[1].header.stamp, ros::Time(7.0));
}

TEST(SimulatorTransforms, WithoutErrorsTellTheTruth) {
  const SimulatorConfig config = configWith(0.0, 0.0);
  const auto messages = messagesAt(config, 3.0);
  const Eigen::Isometry2d map_from_base = transformOf(messages[0]) * transformOf(messages[1]);
  EXPECT_NEAR((map_from_base.translation() - Position(2.5, 1.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(map_from_base.rotation()(0, 0)), 1.0, 1e-9) << "it looks along x";
  EXPECT_NEAR((transformOf(messages[0]).translation() - Position(2, -1)).norm(), 0.0, 1e-12);
}

geometry_msgs::TransformStamped odomFromBase(double stamp_s, double x, double y, double yaw) {
  return toPlanarTransform(ros::Time(stamp_s), "odom", "base_link", {x, y}, yaw);
}

TEST(SimulatorOdometry, HoldsTheLaterPose) {
  const nav_msgs::Odometry odometry =
      odometryMessage(odomFromBase(5.0, 1.0, 2.0, 0.0), odomFromBase(5.1, 1.5, 2.5, 0.6));
  EXPECT_EQ(odometry.header.stamp, ros::Time(5.1));
  EXPECT_EQ(odometry.header.frame_id, "odom");
  EXPECT_EQ(odometry.child_frame_id, "base_link");
  EXPECT_EQ(odometry.pose.pose.position.x, 1.5);
  EXPECT_EQ(odometry.pose.pose.position.y, 2.5);
  EXPECT_DOUBLE_EQ(odometry.pose.pose.orientation.z, std::sin(0.3));
}

TEST(SimulatorOdometry, HoldsTheVelocityInTheFrameOfTheBase) {
  // Ahead along -y, at 0.5 m/s.
  const nav_msgs::Odometry straight = odometryMessage(odomFromBase(5.0, 1.0, 2.0, -0.5 * M_PI),
                                                      odomFromBase(5.2, 1.0, 1.9, -0.5 * M_PI));
  EXPECT_NEAR(straight.twist.twist.linear.x, 0.5, 1e-6);
  EXPECT_NEAR(straight.twist.twist.linear.y, 0.0, 1e-9);
  EXPECT_NEAR(straight.twist.twist.angular.z, 0.0, 1e-9);
  // A quarter of a circle of 1 m radius in one second, across the turn from pi to -pi.
  const double yaw = 0.75 * M_PI;
  const Position centre(-std::sin(yaw), std::cos(yaw));  // 1 m to the left
  const Position end = centre + Position(std::sin(yaw + 0.5 * M_PI), -std::cos(yaw + 0.5 * M_PI));
  const nav_msgs::Odometry arc = odometryMessage(
      odomFromBase(5.0, 0.0, 0.0, yaw), odomFromBase(6.0, end.x(), end.y(), yaw + 0.5 * M_PI));
  EXPECT_NEAR(arc.twist.twist.linear.x, std::sqrt(2.0), 1e-9) << "the chord";
  EXPECT_NEAR(arc.twist.twist.linear.y, 0.0, 1e-9);
  EXPECT_NEAR(arc.twist.twist.angular.z, 0.5 * M_PI, 1e-9);
}

TEST(SimulatorOdometry, StandsStillAtTheStart) {
  const auto start = odomFromBase(5.0, 1.0, 2.0, 0.3);
  const nav_msgs::Odometry odometry = odometryMessage(start, start);
  EXPECT_EQ(odometry.twist.twist.linear.x, 0.0);
  EXPECT_EQ(odometry.twist.twist.angular.z, 0.0);
}

TEST(SimulatorTransforms, ErrAsARecordingDoes) {
  SimulatorConfig config = configWith(0.1, 0.05);
  config.signals.speed_m_s = config.robot.max_speed_m_s;
  const SimulatedDrive drive(kWayPoints, config.signals);
  for (double time_s = 0.0; time_s < drive.duration(); time_s += 2.5) {
    const auto messages = messagesAt(config, time_s);
    const Position believed = (transformOf(messages[0]) * transformOf(messages[1])).translation();
    EXPECT_NEAR((believed - drive.reportedPose(time_s).position).norm(), 0.0, 1e-9);
  }
}

TEST(SimulatorTransforms, OdometryDriftsAndRegistrationShiftsTheOdometrysFrame) {
  const Eigen::Isometry2d exact = transformOf(messagesAt(configWith(0.0, 0.0), 20.0)[1]);
  const auto drifted = messagesAt(configWith(0.0, 0.05), 20.0);
  EXPECT_GT((transformOf(drifted[1]).translation() - exact.translation()).norm(), 0.05);
  EXPECT_NEAR((transformOf(drifted[0]).translation() - Position(2, -1)).norm(), 0.0, 1e-12);
  const auto shifted = messagesAt(configWith(0.1, 0.0), 20.0);
  EXPECT_NEAR((transformOf(shifted[1]).translation() - exact.translation()).norm(), 0.0, 1e-12);
  EXPECT_GT((transformOf(shifted[0]).translation() - Position(2, -1)).norm(), 0.01);
}

}  // namespace
}  // namespace sfw
