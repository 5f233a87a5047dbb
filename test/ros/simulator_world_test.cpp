#include "ros/simulator/simulator_world.h"

#include <gtest/gtest.h>

#include "simulation/building/floor_plan_generator.h"
#include "simulation/radio/noise_level.h"
#include "simulation/robot/route.h"
#include "simulation/robot/route_planner.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/readings_io.h"
#include "support/temporary_folder.h"

namespace sfw {
namespace {

/// Two rooms of 3 x 3 m with a door between them, as HouseExpo draws them.
constexpr char kTwoRooms[] = R"({"verts": [[0, 0], [3, 0], [3, 1], [3.1, 1], [3.1, 0], [6.1, 0],
  [6.1, 3], [3.1, 3], [3.1, 2], [3, 2], [3, 3], [0, 3]]})";

class World : public test::TemporaryFolder {
 protected:
  SimulatorConfig twoRooms() const {
    SimulatorConfig config;
    config.building.plan = write("two_rooms.json", kTwoRooms);
    return config;
  }

  static std::string problemOf(const SimulatorConfig& config) {
    try {
      makeSimulatorWorld(config);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no problem";
  }
};

TEST_F(World, APlanAloneSuffices) {
  const SimulatorConfig config = twoRooms();
  const SimulatorWorld world = makeSimulatorWorld(config);
  const GridGeometry& geometry = world.plan.geometry;
  EXPECT_EQ(world.plan[geometry.cellAt({1.5, 1.5})], Material::kFree);
  EXPECT_EQ(world.plan[geometry.cellAt({3.05, 0.5})], Material::kInteriorWall);
  ASSERT_EQ(world.access_points.size(), 2U);
  EXPECT_NO_THROW(requireFree(toStates(world.plan), world.way_points, config.robot.radius_m));
  bool left = false;
  bool right = false;
  for (const Position& place : world.way_points) {
    left = left || place.x() < 3.0;
    right = right || place.x() > 3.1;
  }
  EXPECT_TRUE(left && right) << "one room was not visited";
}

TEST_F(World, PlacesAccessPointsAsTheCommandDoes) {
  SimulatorConfig config = twoRooms();
  config.access_point_count = 3;
  config.signals.radio.seed = 9;
  const SimulatorWorld world = makeSimulatorWorld(config);
  const std::vector<AccessPoint> expected = placeAccessPoints(world.plan, 3, 9);
  ASSERT_EQ(world.access_points.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(world.access_points[i].position, expected[i].position);
  }
  config.access_points = {expected[1]};
  EXPECT_EQ(makeSimulatorWorld(config).access_points.size(), 1U) << "given ones are enough";
}

TEST_F(World, MakesABuildingUpFromTheSeed) {
  SimulatorConfig config;
  config.building.generate = "office";
  config.building.area_m2 = 120.0;
  config.route = "sparse";
  config.signals.radio.seed = 4;
  BuildingConfig office;
  office.kind = BuildingKind::kOffice;
  office.area_m2 = 120.0;
  office.seed = 4;
  EXPECT_EQ(makeSimulatorWorld(config).plan.cells, generateFloorPlan(office).cells);
}

TEST_F(World, ARouteMayKeepTheNoiseLevelsClearance) {
  SimulatorConfig config = twoRooms();
  config.noise = "hard";
  config.signals.radio.seed = 3;
  const SimulatorWorld world = makeSimulatorWorld(config);
  RoutePlannerConfig planner;
  planner.robot_radius_m = config.robot.radius_m;
  planner.clearance_m = wallClearance(noiseLevel("hard"), 3);
  EXPECT_EQ(world.way_points, planRoute(toStates(world.plan), RouteKind::kWalls, planner));
}

TEST_F(World, ByHandTheRobotStartsWhereTheRouteDoes) {
  SimulatorConfig config = twoRooms();
  const Position start = makeSimulatorWorld(config).way_points.front();
  config.drive = "cmd_vel";
  EXPECT_EQ(makeSimulatorWorld(config).way_points.front(), start);
  config.route = write("route.csv", "x,y\n1,1\n1,2\n");
  EXPECT_EQ(makeSimulatorWorld(config).way_points.front(), Position(1, 1));
}

TEST_F(World, NamesTheFileThatIsWrong) {
  SimulatorConfig config = twoRooms();
  config.route = write("route.csv", "x,y\n1,1\n3.05,0.5\n");
  EXPECT_EQ(problemOf(config).find(config.route + ": way point 2 (3.05, 0.50) is not free"), 0U)
      << problemOf(config);
  config.route = path("none.csv");
  EXPECT_EQ(problemOf(config).find(config.route), 0U) << problemOf(config);
  config.building.plan = path("none.json");
  EXPECT_EQ(problemOf(config).find(config.building.plan), 0U) << problemOf(config);
}

TEST_F(World, SaysThatTheRobotHasNoRoom) {
  SimulatorConfig config = twoRooms();
  config.robot.radius_m = 2.0;
  EXPECT_EQ(problemOf(config).find("route walls: "), 0U) << problemOf(config);
}

TEST_F(World, SaysThatAnAccessPointHasNoRoom) {
  SimulatorConfig config = twoRooms();
  config.building.plan =
      write("closet.json", R"({"verts": [[0, 0], [0.5, 0], [0.5, 0.5], [0, 0.5]]})");
  EXPECT_NE(problemOf(config).find("access point"), std::string::npos) << problemOf(config);
}

}  // namespace
}  // namespace sfw
