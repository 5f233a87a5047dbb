#include "ros/exploration/exploration_messages.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <limits>

#include "ros/consumer_checks.h"
#include "ros/exploration/exploration_settings.h"

namespace sfw {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

nav_msgs::OccupancyGrid grid(std::vector<std::int8_t> data) {
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = "map";
  grid.info.resolution = 0.05F;
  grid.info.width = static_cast<std::uint32_t>(data.size());
  grid.info.height = 1;
  grid.info.origin.orientation.w = 1.0;
  grid.data = std::move(data);
  return grid;
}

nav_msgs::OccupancyGrid::ConstPtr shared(const nav_msgs::OccupancyGrid& grid) {
  return boost::make_shared<nav_msgs::OccupancyGrid>(grid);
}

TEST(ExplorationMessages, GiveStatesAndProbabilities) {
  const auto view = viewOf({shared(grid({-1, 0, 100})), shared(grid({-1, 3, 97})), {}, {}});
  ASSERT_TRUE(view);
  EXPECT_EQ(view->states.cells[0], CellState::kUnknown);
  EXPECT_EQ(view->states.cells[1], CellState::kFree);
  EXPECT_EQ(view->states.cells[2], CellState::kOccupied);
  EXPECT_TRUE(std::isnan(view->occupied.cells[0]));
  EXPECT_FLOAT_EQ(view->occupied.cells[1], 0.03F);
}

TEST(ExplorationMessages, WaitForGridsOfTheSameCells) {
  EXPECT_FALSE(viewOf({shared(grid({0, 0})), nullptr, {}, {}}));
  EXPECT_FALSE(viewOf({shared(grid({0, 0})), shared(grid({0, 0, 0})), {}, {}}));
}

TEST(ExplorationMessages, NameWhatIsWrongWithAGrid) {
  const auto problem = [](auto&& change) {
    nav_msgs::OccupancyGrid one = grid({0, 0});
    change(one);
    return problemOf(one, "map");
  };
  EXPECT_EQ(problem([](auto&) {}), "");
  EXPECT_NE(problem([](auto& one) { one.data.pop_back(); }), "");
  EXPECT_NE(problem([](auto& one) { one.info.width = 4000000000U; }), "");
  EXPECT_NE(problem([](auto& one) { one.info.resolution = 0.0F; }), "");
  EXPECT_NE(problem([](auto& one) { one.info.resolution = 1e-30F; }), "");
  EXPECT_NE(problem([](auto& one) { one.info.origin.position.x = kNan; }), "");
  EXPECT_NE(problem([](auto& one) { one.info.origin.position.y = 1e30; }), "");
  EXPECT_NE(problem([](auto& one) { one.info.origin.orientation.z = 0.7; }), "");
  EXPECT_NE(problem([](auto& one) { one.header.frame_id = "odom"; }).find("'odom'"),
            std::string::npos);
}

TEST(ExplorationMessages, LeaveOutWallsAndAccessPointsThatAreNowhere) {
  auto walls = boost::make_shared<structure_from_wifi::Walls>();
  walls->walls.resize(4);
  for (auto& wall : walls->walls) {
    wall.confidence = 0.5F;
  }
  walls->walls[0].end.x = 1.0;
  walls->walls[1].end.x = kNan;
  walls->walls[2].end.x = 1e9;
  walls->walls[3].confidence = 1.5F;
  auto access_points = boost::make_shared<structure_from_wifi::AccessPoints>();
  access_points->access_points.resize(2);
  access_points->access_points[0].position.x = kNan;
  const auto view = viewOf({shared(grid({0, 0})), shared(grid({1, 1})), walls, access_points});
  ASSERT_TRUE(view);
  EXPECT_EQ(view->walls.size(), 1u);
  EXPECT_EQ(view->access_points.size(), 1u);
}

TEST(ExplorationMessages, DrawGoalsAndTheWay) {
  ExplorationGoal goal;
  goal.way = {{0.0, 0.0}, {1.0, 0.0}};
  goal.position = {1.0, 0.0};
  goal.rate_m2_s = 0.2;
  std_msgs::Header header;
  header.frame_id = "map";
  const auto array = toMarkers({goal, goal}, goal, header);
  EXPECT_EQ(array.markers.size(), 1u + 2u * 2u + 1u);  // what was there goes; balls, texts, a way
  EXPECT_EQ(array.markers.back().points.size(), 2u);
  EXPECT_EQ(consumer::faultOfMarkers(array, "map"), "");
}

TEST(ExplorationSettings, ShippedFileHoldsTheDefaults) {
  const YAML::Node shipped = YAML::LoadFile(SFW_SOURCE_DIR "/config/exploration.yaml");
  const ExplorationSettings settings = explorationSettingsFromYaml(shipped);
  const ExplorationSettings defaults = explorationSettingsFromYaml(YAML::Node());
  EXPECT_TRUE(settings.warnings.empty());
  EXPECT_EQ(shipped.size(), 13u);
  EXPECT_EQ(settings.driver, defaults.driver);
  EXPECT_EQ(settings.autostart, defaults.autostart);
  EXPECT_EQ(settings.map_frame, defaults.map_frame);
  EXPECT_EQ(settings.base_frame, defaults.base_frame);
  EXPECT_EQ(settings.robot.robot_radius_m, defaults.robot.robot_radius_m);
  EXPECT_EQ(settings.robot.speed_m_s, defaults.robot.speed_m_s);
  EXPECT_EQ(settings.robot.yaw_rate_rad_s, defaults.robot.yaw_rate_rad_s);
  EXPECT_EQ(settings.robot.touch_s, defaults.robot.touch_s);
  EXPECT_EQ(settings.robot.view_m, defaults.robot.view_m);
  EXPECT_EQ(settings.robot.least_gain_m2, defaults.robot.least_gain_m2);
  EXPECT_EQ(settings.limits.time_s, defaults.limits.time_s);
  EXPECT_EQ(settings.limits.way_m, defaults.limits.way_m);
  EXPECT_EQ(settings.limits.return_home, defaults.limits.return_home);
}

}  // namespace
}  // namespace sfw
