#include "exploration/way_driver.h"

#include <gtest/gtest.h>

#include "grid/for_each_cell.h"
#include "simulation/robot/simulated_robot.h"

namespace sfw::test {
namespace {

/// A robot that drives in steps of 0.1 s until its driver is no longer on the way.
struct Drive {
  SimulatedRobot robot;
  WayDriver driver{WayDriver::Config()};
  Driver::State state = Driver::State::kDriving;
  double now_s = 0.0;

  void run(double longest_s) {
    const double end = now_s + longest_s;
    while (state == Driver::State::kDriving && now_s < end) {
      state = driver.step(robot.pose(), robot.contact().has_value(), now_s);
      robot.command(driver.command());
      robot.step(0.1);
      now_s += 0.1;
    }
  }
};

Grid<CellState> hall() {
  const GridGeometry geometry(0.05, Position(-3.0, -3.0), 120, 120);
  Grid<CellState> plan(geometry, CellState::kFree);
  forEachCell(geometry, [&](Cell c) {
    if (geometry.centre(c).cwiseAbs().maxCoeff() > 2.5) {
      plan[c] = CellState::kOccupied;
    }
  });
  return plan;
}

TEST(WayDriver, ArrivesAtTheEndOfAWay) {
  Drive drive{SimulatedRobot(hall(), {}, {})};
  drive.driver.follow({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.5}, {-1.0, 1.5}});
  drive.run(60.0);
  EXPECT_EQ(drive.state, Driver::State::kArrived);
  EXPECT_LT((drive.robot.pose().position - Position(-1.0, 1.5)).norm(), 0.15);
}

TEST(WayDriver, BeginsAWayInACurveUnlessItLeadsAside) {
  const auto firstSpeed = [](const Position& to) {
    WayDriver driver{WayDriver::Config()};
    driver.follow({to});
    driver.step(RobotPose(), false, 0.0);
    EXPECT_GT(driver.command().yaw_rate_rad_s, 0.0);
    return driver.command().speed_m_s;
  };
  EXPECT_GT(firstSpeed({2.0, 1.0}), 0.4);
  EXPECT_EQ(firstSpeed({1.0, 2.0}), 0.0);
}

TEST(WayDriver, BacksOffAfterATouch) {
  Drive drive{SimulatedRobot(hall(), {}, {})};
  drive.driver.follow({{0.0, 0.0}, {4.0, 0.3}});
  drive.run(60.0);
  EXPECT_EQ(drive.state, Driver::State::kBlocked);
  const double gap = 2.5 - 0.15 - drive.robot.pose().position.x();
  EXPECT_GT(gap, 0.08);
  EXPECT_LT(gap, 0.3);
}

TEST(WayDriver, FollowsAnotherWayAfterATouch) {
  Drive drive{SimulatedRobot(hall(), {}, {})};
  drive.driver.follow({{4.0, 0.0}});
  drive.run(60.0);
  ASSERT_EQ(drive.state, Driver::State::kBlocked);
  drive.driver.follow({{-1.0, -1.0}});
  drive.state = Driver::State::kDriving;
  drive.run(60.0);
  EXPECT_EQ(drive.state, Driver::State::kArrived);
}

TEST(WayDriver, SaysThatItIsStuck) {
  WayDriver driver{WayDriver::Config()};
  driver.follow({{1.0, 0.0}});
  Driver::State state = Driver::State::kDriving;
  double now_s = 0.0;
  for (; now_s < 1000.0 && state != Driver::State::kStuck; now_s += 0.1) {
    state = driver.step(RobotPose(), false, now_s);  // it never moves
    if (state == Driver::State::kBlocked) {
      driver.follow({{1.0, 0.0}});
    }
  }
  EXPECT_EQ(state, Driver::State::kStuck);
  EXPECT_GT(now_s, 30.0);  // it has tried
  EXPECT_EQ(driver.command().speed_m_s, 0.0);
  EXPECT_EQ(driver.command().yaw_rate_rad_s, 0.0);
}

TEST(WayDriver, StandsWithoutAWay) {
  WayDriver driver{WayDriver::Config()};
  EXPECT_EQ(driver.step(RobotPose(), false, 0.0), Driver::State::kIdle);
  driver.follow({{1.0, 0.0}});
  EXPECT_EQ(driver.step(RobotPose(), false, 0.1), Driver::State::kDriving);
  EXPECT_NE(driver.command().speed_m_s, 0.0);
  driver.stop();
  EXPECT_EQ(driver.step(RobotPose(), false, 0.2), Driver::State::kIdle);
  EXPECT_EQ(driver.command().speed_m_s, 0.0);
}

}  // namespace
}  // namespace sfw::test
