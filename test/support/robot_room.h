#pragma once

#include <gtest/gtest.h>

#include "base/constants.h"
#include "simulation/robot/simulated_robot.h"

namespace sfw::test {

/// A robot that reaches any commanded speed at once and keeps it until the next command.
inline SimulatedRobot::Config quick() {
  SimulatedRobot::Config config;
  config.radius_m = 0.2;
  config.max_speed_m_s = 10.0;
  config.max_yaw_rate_rad_s = 100.0;
  config.acceleration_m_s2 = 1000.0;
  config.yaw_acceleration_rad_s2 = 1e4;
  config.command_timeout_s = 0.0;
  return config;
}

/// A room of 4 x 2 m between (0, 0) and (4, 2), in cells of 0.1 m.
inline Grid<CellState> room() {
  Grid<CellState> plan(GridGeometry(0.1, {-0.1, -0.1}, 42, 22), CellState::kOccupied);
  Cell c;
  for (c.y = 1; c.y <= 20; ++c.y) {
    for (c.x = 1; c.x <= 40; ++c.x) {
      plan[c] = CellState::kFree;
    }
  }
  return plan;
}

/// A robot after it has obeyed one command for a time.
inline SimulatedRobot driven(const Grid<CellState>& plan, const RobotPose& start,
                             const SimulatedRobot::Config& config, const DriveCommand& command,
                             double duration_s) {
  SimulatedRobot robot(plan, start, config);
  EXPECT_TRUE(robot.command(command));
  robot.step(duration_s);
  return robot;
}

}  // namespace sfw::test
