// How walls stop the simulated robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "files/map_server.h"
#include "grid/for_each_cell.h"
#include "simulation/building/floor_plan_generator.h"
#include "simulation/robot/simulated_robot.h"
#include "support/ascii_world.h"
#include "support/robot_room.h"

namespace sfw {
namespace {

using test::driven;
using test::quick;
using test::room;

TEST(SimulatedRobotWalls, AWallStopsItAtAnySpeedAndStep) {
  for (const double speed_m_s : {0.01, 0.3, 2.0, 10.0}) {
    for (const double step_s : {0.02, 0.05, 1.0, 1000.0}) {
      SimulatedRobot robot(room(), {{3.75, 1}, 0.0}, quick());
      ASSERT_TRUE(robot.command({speed_m_s, 0.0}));
      for (double time_s = 0.0; time_s < 6.0; time_s += step_s) {
        robot.step(step_s);
      }
      EXPECT_NEAR(robot.pose().position.x(), 3.8, 2e-6) << speed_m_s << " m/s, " << step_s << " s";
      EXPECT_LE(robot.pose().position.x(), 3.8);
      EXPECT_LT(robot.speed(), 10.0);
      ASSERT_TRUE(robot.contact());
      EXPECT_NEAR((*robot.contact() - Position(4.0, 1.0)).norm(), 0.0, 1e-4);
    }
  }
}

TEST(SimulatedRobotWalls, PressingAgainstAWallDoesNotMoveIt) {
  SimulatedRobot robot = driven(room(), {{3.5, 1}, 0.4}, quick(), {1.0, 0.0}, 2.0);
  const Position stopped = robot.pose().position;
  robot.step(1000.0);
  EXPECT_EQ(robot.pose().position, stopped);
}

TEST(SimulatedRobotWalls, DoesNotSlideAlongAWall) {
  const SimulatedRobot robot = driven(room(), {{3.5, 1}, kPi / 4}, quick(), {1.0, 0.0}, 10.0);
  EXPECT_NEAR((robot.pose().position - Position(3.8, 1.3)).norm(), 0.0, 1e-5);
  EXPECT_TRUE(robot.contact());
}

TEST(SimulatedRobotWalls, ACornerStopsIt) {
  const SimulatedRobot robot = driven(room(), {{3, 1}, kPi / 4}, quick(), {1.0, 0.0}, 10.0);
  EXPECT_NEAR((robot.pose().position - Position(3.8, 1.8)).norm(), 0.0, 1e-5);
}

TEST(SimulatedRobotWalls, TheCornerOfAPillarStopsItWhereTheRimTouchesIt) {
  Grid<CellState> plan = room();
  plan[plan.geometry.cellAt({2.05, 0.95})] = CellState::kOccupied;  // its corner is at (2, 1)
  const double off_axis = 0.12;
  const SimulatedRobot robot = driven(plan, {{1, 1 + off_axis}, 0.0}, quick(), {3.0, 0.0}, 2.0);
  EXPECT_NEAR(robot.pose().position.x(), 2.0 - std::sqrt(0.2 * 0.2 - off_axis * off_axis), 1e-5);
  ASSERT_TRUE(robot.contact());
  EXPECT_NEAR((*robot.contact() - Position(2, 1)).norm(), 0.0, 1e-4);
}

TEST(SimulatedRobotWalls, UnknownCellsAndThePlansEdgeStopIt) {
  Grid<CellState> plan(GridGeometry(0.5, {0, 0}, 6, 2), CellState::kFree);
  const RobotPose start{{1, 0.5}, 0.0};
  EXPECT_NEAR(driven(plan, start, quick(), {1.0, 0.0}, 9.0).pose().position.x(), 2.8, 1e-5);
  plan[{4, 1}] = CellState::kUnknown;
  EXPECT_NEAR(driven(plan, start, quick(), {1.0, 0.0}, 9.0).pose().position.x(), 1.8, 1e-5);
}

TEST(SimulatedRobotWalls, FitsThroughAGapOfItsWidthOnly) {
  const auto withGap = [](double resolution) {
    return test::world({"....#....",  //
                        "....#....",  //
                        ".........",  //
                        "....#....",  //
                        "....#...."},
                       resolution);
  };
  for (const auto& [resolution, fits] : {std::pair(0.399, false), std::pair(0.41, true)}) {
    const Position start(2.0 * resolution, 2.5 * resolution);
    const SimulatedRobot robot =
        driven(withGap(resolution), {start, 0.0}, quick(), {1.0, 0.0}, 1.5);
    EXPECT_EQ(robot.pose().position.x() > 5.5 * resolution, fits) << resolution;
    EXPECT_EQ(robot.contact().has_value(), !fits);
  }
}

TEST(SimulatedRobotWalls, GetsAwayFromAWallBackwardsAndByTurning) {
  SimulatedRobot backwards = driven(room(), {{3.5, 1}, 0.2}, quick(), {1.0, 0.0}, 2.0);
  SimulatedRobot turning = backwards;
  ASSERT_TRUE(backwards.contact());
  ASSERT_TRUE(backwards.command({-0.5, 0.0}));
  backwards.step(1.0);
  EXPECT_NEAR(backwards.pose().position.x(), 3.8 - 0.5 * std::cos(0.2), 1e-4);
  EXPECT_FALSE(backwards.contact());

  ASSERT_TRUE(turning.command({0.0, kPi}));
  turning.step(1.0);
  EXPECT_FALSE(turning.contact()) << "the wall is behind it";
  ASSERT_TRUE(turning.command({0.5, 0.0}));
  turning.step(1.0);
  EXPECT_LT(turning.pose().position.x(), 3.4);
}

TEST(SimulatedRobotWalls, DrivesAlongAWallThatItTouches) {
  SimulatedRobot robot = driven(room(), {{2, 1}, kPi / 2}, quick(), {1.0, 0.0}, 2.0);
  ASSERT_TRUE(robot.contact());
  ASSERT_TRUE(robot.command({0.0, -kPi / 2}));
  robot.step(1.0);
  ASSERT_TRUE(robot.command({}));
  robot.step(0.1);
  ASSERT_NEAR(robot.pose().yaw_rad, 0.0, 1e-9);
  ASSERT_TRUE(robot.command({0.5, -1e-7}));
  robot.step(2.0);
  EXPECT_NEAR(robot.pose().position.x(), 3.0, 1e-3);
  EXPECT_NEAR(robot.pose().position.y(), 1.8, 1e-5);
}

TEST(SimulatedRobotWalls, FeelsNothingBehindIt) {
  const SimulatedRobot robot = driven(room(), {{1, 1}, 0.0}, quick(), {-1.0, 0.0}, 2.0);
  EXPECT_NEAR(robot.pose().position.x(), 0.2, 1e-5);
  EXPECT_FALSE(robot.contact());
}

/// Distance from a point to the nearest obstacle, by looking at every cell [m].
double clearanceAt(const Grid<CellState>& plan, const Position& point) {
  const GridGeometry& geometry = plan.geometry;
  const Box bounds = geometry.box();
  double nearest = std::min((point - bounds.min()).minCoeff(), (bounds.max() - point).minCoeff());
  const Position half_cell = Position::Constant(0.5 * geometry.resolution());
  forEachCell(geometry, [&](Cell c) {
    if (plan[c] != CellState::kFree) {
      const Position centre = geometry.centre(c);
      const Box square(centre - half_cell, centre + half_cell);
      nearest = std::min(nearest, square.exteriorDistance(point));
    }
  });
  return nearest;
}

/// Commands as a child would give them; the robot may be anywhere, but never in a wall.
void expectNoOverlap(const Grid<CellState>& plan, const RobotPose& start, std::int64_t seed) {
  SimulatedRobot::Config config = quick();
  config.radius_m = 0.17;
  config.acceleration_m_s2 = 20.0;
  SimulatedRobot robot(plan, start, config);
  int contacts = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    Random random(seed, 1, i);
    const double most_m_s = i % 3 == 0 ? 10.0 : 1.0;
    ASSERT_TRUE(robot.command({random.uniform(-most_m_s / 2, most_m_s), random.uniform(-4, 4)}));
    robot.step(random.uniform(0.0, 0.5));
    ASSERT_GE(clearanceAt(plan, robot.pose().position), config.radius_m - 1e-9) << "step " << i;
    contacts += robot.contact() ? 1 : 0;
  }
  EXPECT_GT(contacts, 10);
  EXPECT_GT(robot.drivenDistance(), 20.0);
}

/// Some place with this clearance, anywhere.
Position placeWithClearance(const Grid<CellState>& plan, double clearance_m) {
  const GridGeometry& geometry = plan.geometry;
  for (std::uint64_t i = 0;; ++i) {
    Random random(1, 2, i);
    const Position place(geometry.box().min().x() + random.uniform() * geometry.box().sizes().x(),
                         geometry.box().min().y() + random.uniform() * geometry.box().sizes().y());
    if (clearanceAt(plan, place) > clearance_m) {
      return place;
    }
  }
}

TEST(SimulatedRobotWalls, IsNeverInAWall) {
  const Grid<CellState> flat = readMap(SFW_SOURCE_DIR "/config/demo/flat.yaml");
  BuildingConfig turned;
  turned.rotation_rad = 0.3;
  turned.resolution_m = 0.1;
  const Grid<CellState> slanting = toStates(generateFloorPlan(turned));
  for (const Grid<CellState>& plan : {room(), flat, slanting}) {
    const RobotPose start{placeWithClearance(plan, 0.25), 0.0};
    for (std::int64_t seed = 1; seed <= 3; ++seed) {
      expectNoOverlap(plan, start, seed);
    }
  }
}

}  // namespace
}  // namespace sfw
