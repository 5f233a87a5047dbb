#include "simulation/robot/route_planner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>

#include "simulation/building/floor_plan_generator.h"
#include "simulation/building/floor_plan_io.h"
#include "simulation/robot/route.h"
#include "structure_from_wifi/input_error.h"
#include "support/ascii_world.h"
#include "support/floor_plans.h"
#include "support/route_figures.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;
using test::coverage;
using test::crossed;
using test::roomsAndEntered;

/// Three rooms in a row, the last one shut; 0.2 m cells.
Grid<CellState> threeRooms() {
  return test::world({"###################################",  //
                      "#............#............#.......#",  //
                      "#............#............#.......#",  //
                      "#............#............#.......#",  //
                      "#.........................#.......#",  //
                      "#.........................#.......#",  //
                      "#.........................#.......#",  //
                      "#.........................#.......#",  //
                      "#............#............#.......#",  //
                      "#............#............#.......#",  //
                      "#............#............#.......#",  //
                      "###################################"},
                     0.2);
}

RoutePlannerConfig robot(double radius) {
  RoutePlannerConfig config;
  config.robot_radius_m = radius;
  return config;
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// ---- Small worlds ----

TEST(RoutePlanner, FollowsTheWallsAtAClearanceAndCrosses) {
  const Grid<CellState> plan = test::world({"#############",  //
                                            "#...........#",  //
                                            "#...........#",  //
                                            "#...........#",  //
                                            "#...........#",  //
                                            "#...........#",  //
                                            "#...........#",  //
                                            "#...........#",  //
                                            "#...........#",  //
                                            "#############"},
                                           0.25);
  const std::vector<Position> route = planRoute(plan, RouteKind::kWalls, robot(0.2));
  EXPECT_EQ(test::rowsOf(crossed(plan.geometry, route)), (Rows{".............",  //
                                                               ".............",  //
                                                               "..#########..",  //
                                                               "..#.......#..",  //
                                                               "..#########..",  //
                                                               "..###.....#..",  //
                                                               "..###.....#..",  //
                                                               "..#########..",  //
                                                               ".............",  //
                                                               "............."}));
}

TEST(RoutePlanner, PatrolsWithAFewWayPoints) {
  const Grid<CellState> plan = threeRooms();
  const std::vector<Position> route = planRoute(plan, RouteKind::kSparse, robot(0.2));
  EXPECT_LE(route.size(), 10u);
  EXPECT_NO_THROW(requireFree(plan, route, 0.2));
  EXPECT_EQ(roomsAndEntered(plan, route, 0.2), std::make_pair(2, 2));
}

TEST(RoutePlanner, GoesThroughDoorsButNotThroughWalls) {
  const Grid<CellState> plan = threeRooms();
  const std::vector<Position> route = planRoute(plan, RouteKind::kWalls, robot(0.2));
  EXPECT_NO_THROW(requireFree(plan, route, 0.2));
  EXPECT_GT(coverage(plan, route, 0.2), 0.99);
  double east = 0.0;
  for (const Position& way_point : route) {
    east = std::max(east, way_point.x());
  }
  EXPECT_GT(east, 4.0);  // the second room
  EXPECT_LT(east, 5.2);  // not the third
}

TEST(RoutePlanner, AWideRobotStaysWhereItFits) {
  const Grid<CellState> plan = threeRooms();
  for (const RouteKind kind : {RouteKind::kWalls, RouteKind::kSparse}) {
    const std::vector<Position> route = planRoute(plan, kind, robot(0.45));
    EXPECT_NO_THROW(requireFree(plan, route, 0.45));
    for (const Position& way_point : route) {
      EXPECT_LT(way_point.x(), 2.6);
    }
  }
}

TEST(RoutePlanner, StartsWhereItIsTold) {
  const Grid<CellState> plan = threeRooms();
  RoutePlannerConfig config = robot(0.2);
  config.start_in_map = Position(6.0, 1.0);  // in the room that is shut
  const std::vector<Position> route = planRoute(plan, RouteKind::kWalls, config);
  EXPECT_LT((route.front() - *config.start_in_map).norm(), 0.15);
  for (const Position& way_point : route) {
    EXPECT_GT(way_point.x(), 5.2);
  }
}

TEST(RoutePlanner, GoesRoundThingsThatStandInARoom) {
  const Grid<CellState> plan = test::world({"#####################",  //
                                            "#...................#",  //
                                            "#...................#",  //
                                            "#...................#",  //
                                            "#...................#",  //
                                            "#........###........#",  //
                                            "#........###........#",  //
                                            "#........###........#",  //
                                            "#...................#",  //
                                            "#...................#",  //
                                            "#...................#",  //
                                            "#...................#",  //
                                            "#####################"},
                                           0.25);
  const std::vector<Position> route = planRoute(plan, RouteKind::kWalls, robot(0.2));
  EXPECT_NO_THROW(requireFree(plan, route, 0.2));
  // On each side of it, within 1 m.
  const Mask path = crossed(plan.geometry, route);
  const auto any = [&](Cell from, Cell to) {
    for (std::int64_t y = from.y; y <= to.y; ++y) {
      for (std::int64_t x = from.x; x <= to.x; ++x) {
        if (path[{x, y}] != 0) {
          return true;
        }
      }
    }
    return false;
  };
  EXPECT_TRUE(any({5, 6}, {8, 6}) && any({12, 6}, {15, 6}));
  EXPECT_TRUE(any({10, 2}, {10, 4}) && any({10, 8}, {10, 10}));
}

TEST(RoutePlanner, VisitsPlacesTooNarrowForItsClearance) {
  // A passage of 0.75 m.
  const Grid<CellState> plan = test::world({"########################",  //
                                            "#.......################",  //
                                            "#.......################",  //
                                            "#......................#",  //
                                            "#......................#",  //
                                            "#......................#",  //
                                            "#.......################",  //
                                            "#.......################",  //
                                            "########################"},
                                           0.25);
  for (const RouteKind kind : {RouteKind::kWalls, RouteKind::kSparse}) {
    const std::vector<Position> route = planRoute(plan, kind, robot(0.15));
    EXPECT_NO_THROW(requireFree(plan, route, 0.15));
    double east = 0.0;
    for (const Position& way_point : route) {
      east = std::max(east, way_point.x());
    }
    EXPECT_GT(east, 4.5);
  }
}

TEST(RoutePlanner, MakesARouteOfTheSmallestRoom) {
  const Grid<CellState> plan = test::world({"#######",  //
                                            "#.....#",  //
                                            "#.....#",  //
                                            "#.....#",  //
                                            "#.....#",  //
                                            "#######"},
                                           0.1);
  for (const RouteKind kind : {RouteKind::kWalls, RouteKind::kSparse}) {
    const std::vector<Position> route = planRoute(plan, kind, robot(0.1));
    EXPECT_GE(route.size(), 2u);
    EXPECT_NO_THROW(requireFree(plan, route, 0.1));
    EXPECT_NO_THROW(Route(route, 0.3, 1.0));
  }
}

// ---- Complaints ----

TEST(RoutePlanner, SaysWhyThereIsNoRoute) {
  const Grid<CellState> plan = threeRooms();
  EXPECT_EQ(messageOf([&] { planRoute(plan, RouteKind::kWalls, robot(2.0)); }),
            "the plan has no free space for a robot of 2.00 m radius; lower robot_radius");
  RoutePlannerConfig config = robot(0.2);
  config.start_in_map = Position(0.1, 0.1);
  EXPECT_EQ(messageOf([&] { planRoute(plan, RouteKind::kWalls, config); }),
            "start (0.10, 0.10) is not free for a robot of 0.20 m radius");
  config.start_in_map = Position(-50.0, 0.1);
  EXPECT_EQ(messageOf([&] { planRoute(plan, RouteKind::kWalls, config); }),
            "start (-50.00, 0.10) is not free for a robot of 0.20 m radius");
  const Grid<CellState> cell = test::world({"###", "#.#", "###"}, 1.0);
  EXPECT_EQ(messageOf([&] { planRoute(cell, RouteKind::kSparse, robot(0.2)); }),
            "the robot cannot move from its start; lower robot_radius");
}

TEST(RoutePlanner, ListsEveryBadSetting) {
  RoutePlannerConfig config;
  config.robot_radius_m = 0.0;
  config.clearance_m = -1.0;
  config.start_in_map = Position(std::nan(""), 0.0);
  EXPECT_EQ(messageOf([&] { planRoute(threeRooms(), RouteKind::kWalls, config); }),
            "robot_radius must lie in 0.01..5 m; it is 0\n"
            "clearance must lie in 0..5 m; it is -1\n"
            "start must be finite and within 1000 km of the origin");
}

// ---- Properties over generated buildings ----

TEST(RoutePlanner, DrivesThroughGeneratedBuildings) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    BuildingConfig building;
    building.kind = seed % 2 == 0 ? BuildingKind::kFlat : BuildingKind::kOffice;
    building.area_m2 = 30.0 + 15.0 * static_cast<double>(seed);
    building.seed = seed;
    building.rotation_rad = seed % 3 == 0 ? 0.1 * static_cast<double>(seed) : 0.0;
    const Grid<CellState> plan = toStates(generateFloorPlan(building));
    RoutePlannerConfig config = robot(seed % 4 == 0 ? 0.25 : 0.17);
    config.clearance_m = seed % 5 == 0 ? 0.0 : 0.3;
    for (const RouteKind kind : {RouteKind::kWalls, RouteKind::kSparse}) {
      const std::vector<Position> route = planRoute(plan, kind, config);
      EXPECT_NO_THROW(requireFree(plan, route, config.robot_radius_m)) << "seed " << seed;
      EXPECT_EQ(route, planRoute(plan, kind, config)) << "seed " << seed;
      if (kind == RouteKind::kWalls) {
        EXPECT_GT(coverage(plan, route, config.robot_radius_m), 0.9) << "seed " << seed;
      } else {
        const auto [rooms, entered] = roomsAndEntered(plan, route, config.robot_radius_m);
        EXPECT_EQ(entered, rooms) << "seed " << seed;
      }
    }
  }
}

TEST(RoutePlanner, IsFastEnoughForAHome) {
  BuildingConfig building;
  building.area_m2 = 100.0;
  const Grid<CellState> plan = toStates(generateFloorPlan(building));
  const auto start = std::chrono::steady_clock::now();
  planRoute(plan, RouteKind::kWalls);
  planRoute(plan, RouteKind::kSparse);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 2.0);
}

// ---- Real plans ----

TEST(RoutePlannerRealPlans, WallsSeesAndSparseEntersEverything) {
  const std::vector<std::string> files = test::floorPlans();
  if (files.empty()) {
    GTEST_SKIP() << test::kNoFloorPlans;
  }
  constexpr double kRadius = 0.2;
  for (const std::string& file : files) {
    const Grid<CellState> plan = toStates(readFloorPlan(file));
    const std::vector<Position> walls = planRoute(plan, RouteKind::kWalls, robot(kRadius));
    EXPECT_NO_THROW(requireFree(plan, walls, kRadius)) << file;
    EXPECT_GE(coverage(plan, walls, kRadius), 0.9) << file;
    const std::vector<Position> sparse = planRoute(plan, RouteKind::kSparse, robot(kRadius));
    EXPECT_NO_THROW(requireFree(plan, sparse, kRadius)) << file;
    const auto [rooms, entered] = roomsAndEntered(plan, sparse, kRadius);
    EXPECT_GE(rooms, 1) << file;
    EXPECT_EQ(entered, rooms) << file;
  }
}

}  // namespace
}  // namespace sfw
