#include "simulation/robot/simulated_robot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "structure_from_wifi/input_error.h"
#include "support/robot_room.h"

namespace sfw {
namespace {

using test::driven;
using test::quick;
using test::room;

// ---- Kinematics ----

TEST(SimulatedRobot, DrivesStraightAtItsSpeed) {
  const SimulatedRobot robot = driven(room(), {{1, 1}, kPi / 6}, quick(), {0.5, 0.0}, 1.0);
  EXPECT_NEAR((robot.pose().position - Position(1 + 0.5 * std::cos(kPi / 6), 1.25)).norm(), 0.0,
              1e-9);
  EXPECT_NEAR(robot.pose().yaw_rad, kPi / 6, 1e-12);
  EXPECT_NEAR(robot.drivenDistance(), 0.5, 1e-9);
  EXPECT_FALSE(robot.contact());
}

TEST(SimulatedRobot, TurnsOnTheSpot) {
  const SimulatedRobot robot = driven(room(), {{1, 1}, 0.0}, quick(), {0.0, -kPi / 2}, 1.0);
  EXPECT_EQ(robot.pose().position, Position(1, 1));
  EXPECT_NEAR(robot.pose().yaw_rad, -kPi / 2, 1e-9);
  EXPECT_EQ(robot.drivenDistance(), 0.0);
}

TEST(SimulatedRobot, DrivesACircleBackToItsStart) {
  const double radius_m = 0.5;
  SimulatedRobot robot(room(), {{1.5, 0.5}, 0.0}, quick());
  ASSERT_TRUE(robot.command({radius_m * kPi / 2, kPi / 2}));  // 4 s a circle about (1.5, 1)
  robot.step(1.0);
  EXPECT_NEAR((robot.pose().position - Position(2.0, 1.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(robot.pose().yaw_rad, kPi / 2, 1e-9);
  robot.step(3.0);
  EXPECT_NEAR((robot.pose().position - Position(1.5, 0.5)).norm(), 0.0, 1e-6);
}

TEST(SimulatedRobot, TheSameCommandsInOtherStepsGiveTheSameDrive) {
  SimulatedRobot whole(room(), {{1, 1}, 0.3}, quick());
  SimulatedRobot parts = whole;
  for (SimulatedRobot* robot : {&whole, &parts}) {
    ASSERT_TRUE(robot->command({0.4, 0.7}));
  }
  whole.step(1.0);
  for (int i = 0; i < 20; ++i) {
    parts.step(0.05);
  }
  EXPECT_NEAR((whole.pose().position - parts.pose().position).norm(), 0.0, 1e-9);
}

TEST(SimulatedRobot, SpeedsUpAndBrakes) {
  SimulatedRobot::Config config = quick();
  config.acceleration_m_s2 = 0.5;
  SimulatedRobot robot(room(), {{0.5, 1}, 0.0}, config);
  ASSERT_TRUE(robot.command({1.0, 0.0}));
  robot.step(1.0);
  EXPECT_NEAR(robot.speed(), 0.5, 1e-9);
  EXPECT_NEAR(robot.drivenDistance(), 0.25, 0.01);  // a t^2 / 2
  ASSERT_TRUE(robot.command({}));
  robot.step(2.0);
  EXPECT_EQ(robot.speed(), 0.0);
  EXPECT_NEAR(robot.drivenDistance(), 0.5, 0.01);
}

TEST(SimulatedRobot, KeepsToItsLimits) {
  SimulatedRobot::Config config = quick();
  config.max_speed_m_s = 0.3;
  config.max_yaw_rate_rad_s = 0.1;
  const SimulatedRobot robot = driven(room(), {{2, 1}, 0.0}, config, {-5.0, 5.0}, 1.0);
  EXPECT_NEAR(robot.speed(), -0.3, 1e-12);
  EXPECT_NEAR(robot.pose().yaw_rad, 0.1, 1e-6);
  EXPECT_NEAR(robot.pose().position.x(), 1.7, 0.01);
}

TEST(SimulatedRobot, StopsWhenNoCommandsCome) {
  SimulatedRobot::Config config = quick();
  config.command_timeout_s = 0.5;
  SimulatedRobot robot(room(), {{1, 1}, 0.0}, config);
  ASSERT_TRUE(robot.command({0.4, 0.0}));
  robot.step(0.4);
  ASSERT_TRUE(robot.command({0.4, 0.0}));
  robot.step(3.0);
  EXPECT_NEAR(robot.drivenDistance(), 0.9 * 0.4, 1e-9);
  EXPECT_EQ(robot.speed(), 0.0);
}

TEST(SimulatedRobot, IgnoresCommandsThatAreNotFinite) {
  SimulatedRobot robot(room(), {{1, 1}, 0.0}, quick());
  ASSERT_TRUE(robot.command({0.4, 0.0}));
  EXPECT_FALSE(robot.command({std::numeric_limits<double>::quiet_NaN(), 0.0}));
  EXPECT_FALSE(robot.command({0.0, std::numeric_limits<double>::infinity()}));
  robot.step(1.0);
  EXPECT_NEAR(robot.drivenDistance(), 0.4, 1e-9);
}

// ---- Bad input ----

std::string problemOf(const RobotPose& start, const SimulatedRobot::Config& config) {
  try {
    const SimulatedRobot robot(room(), start, config);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SimulatedRobot, NeedsRoomToStand) {
  EXPECT_EQ(problemOf({{0.2, 0.2}, 0.0}, quick()), "no error") << "it may touch walls";
  EXPECT_EQ(problemOf({{0.15, 1.05}, 0.0}, quick()),
            "the robot does not fit at (0.15, 1.05): (-0.05, 0.95) is not free");
  EXPECT_EQ(problemOf({{50, 50}, 0.0}, quick()).find("the robot does not fit at (50.00, 50.00)"),
            0U);
}

TEST(SimulatedRobot, NamesEverySettingOutOfRange) {
  SimulatedRobot::Config config;
  config.radius_m = 0.0;
  config.max_speed_m_s = std::numeric_limits<double>::quiet_NaN();
  config.max_yaw_rate_rad_s = -1.0;
  config.acceleration_m_s2 = 0.0;
  config.yaw_acceleration_rad_s2 = 0.0;
  config.command_timeout_s = -1.0;
  EXPECT_EQ(problemOf({{2, 1}, 0.0}, config),
            "radius must lie in 0.01..10; it is 0\n"
            "max_speed must lie in 0.01..10; it is nan\n"
            "max_yaw_rate must lie in 0.01..100; it is -1\n"
            "acceleration must lie in 0.01..1000; it is 0\n"
            "yaw_acceleration must lie in 0.01..10000; it is 0\n"
            "command_timeout must lie in 0..3600; it is -1");
}

}  // namespace
}  // namespace sfw
