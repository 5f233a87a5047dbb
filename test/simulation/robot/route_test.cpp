#include "simulation/robot/route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "base/constants.h"
#include "files/map_server.h"
#include "simulation/building/wall_crossings.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/readings_io.h"
#include "support/ascii_world.h"

namespace sfw {
namespace {

/// A plan of 1 m cells.
Grid<CellState> drawn(const std::vector<std::string>& rows) { return test::world(rows, 1.0); }

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

// ---- Route ----

TEST(Route, DrivesAtConstantSpeedAndTurnsOnTheSpot) {
  const Route route({{0, 0}, {2, 0}, {2, 1}}, 0.5, kPi / 4);  // 4 s, turn of 2 s, 2 s
  EXPECT_NEAR(route.duration(), 8.0, 1e-12);

  EXPECT_EQ(route.poseAt(0.0).position, Position(0, 0));
  EXPECT_NEAR(route.poseAt(3.0).position.x(), 1.5, 1e-12);
  EXPECT_NEAR(route.poseAt(3.0).yaw_rad, 0.0, 1e-12);

  EXPECT_NEAR((route.poseAt(5.0).position - Position(2, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(route.poseAt(5.0).yaw_rad, kPi / 4, 1e-12);

  EXPECT_NEAR((route.poseAt(7.0).position - Position(2, 0.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(route.poseAt(7.0).yaw_rad, kPi / 2, 1e-12);
}

TEST(Route, KnowsTheWayDriven) {
  const Route route({{0, 0}, {2, 0}, {2, 1}}, 0.5, kPi / 4);  // 4 s, turn of 2 s, 2 s
  EXPECT_EQ(route.drivenAt(-1.0), 0.0);
  EXPECT_NEAR(route.drivenAt(3.0), 1.5, 1e-12);
  EXPECT_NEAR(route.drivenAt(5.0), 2.0, 1e-12);
  EXPECT_NEAR(route.drivenAt(7.0), 2.5, 1e-12);
  EXPECT_NEAR(route.drivenAt(100.0), 3.0, 1e-12);
}

TEST(Route, StaysAtItsEnds) {
  const Route route({{1, 1}, {1, 3}}, 1.0, 1.0);
  EXPECT_EQ(route.poseAt(-5.0).position, Position(1, 1));
  EXPECT_NEAR((route.poseAt(100.0).position - Position(1, 3)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(route.poseAt(100.0).yaw_rad, kPi / 2, 1e-12);
}

TEST(Route, TurnsTheShortWay) {
  // Heading 135 degrees, then -135: a quarter turn through 180, not three through 0.
  const Route route({{0, 0}, {-1, 1}, {-2, 0}}, std::sqrt(2.0), kPi / 2);
  EXPECT_NEAR(route.duration(), 3.0, 1e-12);
  EXPECT_NEAR(std::cos(route.poseAt(1.5).yaw_rad), -1.0, 1e-12);
}

TEST(Route, NeverJumps) {
  const Route route({{0, 0}, {3, 1}, {3, 1}, {0, 0.5}, {2, 2}}, 0.5, 2.0);
  constexpr double kStep = 0.001;
  for (double t = 0.0; t < route.duration(); t += kStep) {
    const RobotPose a = route.poseAt(t), b = route.poseAt(t + kStep);
    EXPECT_LE((b.position - a.position).norm(), 0.5 * kStep + 1e-12);
    EXPECT_LE(std::abs(std::remainder(b.yaw_rad - a.yaw_rad, 2 * kPi)), 2.0 * kStep + 1e-12);
  }
}

TEST(Route, RefusesWhatIsNoRoute) {
  EXPECT_THROW(Route({}, 1, 1), InputError);
  EXPECT_THROW(Route({{1, 1}}, 1, 1), InputError);
  EXPECT_THROW(Route({{1, 1}, {1, 1}}, 1, 1), InputError);
  EXPECT_THROW(Route({{0, 0}, {1, 1}}, 0, 1), std::invalid_argument);
  EXPECT_THROW(Route({{0, 0}, {1, 1}}, 1, NAN), std::invalid_argument);
}

// ---- requireFree ----

TEST(RequireFree, AcceptsARouteWithClearance) {
  const Grid<CellState> plan = drawn({"#######",  //
                                      "#.....#",  //
                                      "#.....#",  //
                                      "#.....#",  //
                                      "#######"});
  EXPECT_NO_THROW(requireFree(plan, {{2.5, 2.5}, {4.5, 2.5}}, 0.9));
  EXPECT_THROW(requireFree(plan, {{2.5, 2.5}, {4.5, 2.5}}, 1.6), InputError);
}

TEST(RequireFree, NamesEachBlockedWayPointAndStretch) {
  const Grid<CellState> plan = drawn({"...#...",  //
                                      "...#...",  //
                                      "......?"});
  const std::vector<Position> way_points = {{1.5, 2.5}, {5.5, 2.5}, {3.5, 1.5},
                                            {5.5, 1.5}, {6.5, 0.5}, {-3.0, 0.0}};
  EXPECT_EQ(messageOf([&] { requireFree(plan, way_points, 0.1); }),
            "the stretch from way point 1 (1.50, 2.50) to way point 2 (5.50, 2.50) is not free: "
            "(3.50, 2.50) is occupied\n"
            "way point 3 (3.50, 1.50) is not free: (3.50, 1.50) is occupied\n"
            "way point 5 (6.50, 0.50) is not free: (6.50, 0.50) is unknown\n"
            "way point 6 (-3.00, 0.00) is not free: (-3.50, -0.50) is outside the plan");
}

// ---- The demo's world ----

TEST(Demo, ItsRouteCanBeDrivenAndTakesHalfAMinute) {
  const std::string folder = SFW_SOURCE_DIR "/config/demo/";
  const Grid<CellState> plan = readMap(folder + "flat.yaml");
  const std::vector<Position> way_points = readWayPoints(folder + "route.csv");
  EXPECT_NO_THROW(requireFree(plan, way_points, 0.25));
  const double real_time_s = Route(way_points, 0.5, 2.0).duration() / 6.0;
  EXPECT_GT(real_time_s, 20.0);
  EXPECT_LT(real_time_s, 30.0);
}

TEST(Demo, ItsAccessPointsHearZeroToSeveralWalls) {
  const std::string folder = SFW_SOURCE_DIR "/config/demo/";
  const Grid<CellState> plan = readMap(folder + "flat.yaml");
  const Route route(readWayPoints(folder + "route.csv"), 0.5, 2.0);
  for (const AccessPoint& access_point :
       readAccessPoints(folder + "access_points.yaml").access_points) {
    EXPECT_EQ(plan[plan.geometry.cellAt(access_point.position)], CellState::kFree);
    int most = 0, fewest = 99;
    for (double t = 0.0; t < route.duration(); t += 0.2) {
      const int walls = countWalls(plan, access_point.position, route.poseAt(t).position);
      most = std::max(most, walls);
      fewest = std::min(fewest, walls);
    }
    EXPECT_EQ(fewest, 0);
    EXPECT_GE(most, 2);
    EXPECT_LE(most, 5);
  }
}

}  // namespace
}  // namespace sfw
