// Watches a mapper from its first map to its reset, whoever started it: mapping.launch as a node or
// in a manager (this test then plays the robot), demo.launch or replay.launch (they bring a robot).
// The tests build on each other, in this order.

#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <octomap_msgs/GetOctomap.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <structure_from_wifi/SaveMap.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mapping_launch_world.h"
#include "ros/service_call.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

using Mapping = LaunchWorld;

/// Cells of a map with a value.
std::size_t count(const nav_msgs::OccupancyGrid& map, int value) {
  return static_cast<std::size_t>(std::count(map.data.begin(), map.data.end(), value));
}

/// Everything below a directory with its content, to see whether it was touched.
std::map<fs::path, std::string> contentOf(const fs::path& directory) {
  std::map<fs::path, std::string> content;
  if (fs::exists(directory)) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      content[entry.path()] =
          entry.is_regular_file() ? std::string(std::istreambuf_iterator<char>(stream), {}) : "";
    }
  }
  return content;
}

structure_from_wifi::SaveMap::Response save(const std::string& directory) {
  structure_from_wifi::SaveMap call;
  call.request.directory = directory;
  EXPECT_TRUE(callService(Mapping::mapper() + "/save_map", call));
  return call.response;
}

TEST_F(Mapping, TheFirstMapComesAtOnceAndIsUnknown) {
  const ros::WallTime start = ros::WallTime::now();
  ASSERT_TRUE(spinUntil([] { return world().map != nullptr; }, 30.0));
  RecordProperty("milliseconds", static_cast<int>((ros::WallTime::now() - start).toSec() * 1000.0));
  if (param("first_map_is_unknown", true)) {
    EXPECT_EQ(count(*world().map, -1), world().map->data.size());
  }
}

TEST_F(Mapping, TheMapIsLatched) {
  bool came = false;
  ros::NodeHandle node;
  const ros::Subscriber late = node.subscribe<nav_msgs::OccupancyGrid>(
      "map", 1, [&](const nav_msgs::OccupancyGridConstPtr&) { came = true; });
  EXPECT_TRUE(spinUntil([&] { return came; }, 30.0));
}

TEST_F(Mapping, ADriveMakesAMap) {
  ASSERT_NE(world().map, nullptr);
  if (param("drive", true)) {
    ASSERT_TRUE(drive());
  }
  ASSERT_TRUE(spinUntil([] { return count(*world().map, 0) > 100; }, param("map_within", 20.0)));
  waitUntilQuiet();
  EXPECT_GT(count(*world().map, -1), 0U);
  EXPECT_GE(world().consumers->layer().maps(), 2U);
}

TEST_F(Mapping, MetadataAndProbabilityBelongToTheMap) {
  ASSERT_TRUE(world().map && world().metadata && world().probability);
  EXPECT_EQ(*world().metadata, world().map->info);
  EXPECT_EQ(world().probability->info, world().map->info);
  ASSERT_EQ(world().probability->data.size(), world().map->data.size());
  for (std::size_t i = 0; i < world().map->data.size(); ++i) {
    const int percent = world().probability->data[i];
    ASSERT_TRUE(percent >= -1 && percent <= 100) << percent;
  }
  EXPECT_GT(count(*world().probability, -1), 0U) << "no cell is unknown";
  ASSERT_NE(world().path, nullptr);
  ASSERT_FALSE(world().path->poses.empty());
  const nav_msgs::MapMetaData& info = world().map->info;
  for (const geometry_msgs::PoseStamped& pose : world().path->poses) {
    const double x = (pose.pose.position.x - info.origin.position.x) / info.resolution;
    const double y = (pose.pose.position.y - info.origin.position.y) / info.resolution;
    const std::size_t cell = static_cast<std::size_t>(y) * info.width + static_cast<std::size_t>(x);
    EXPECT_EQ(static_cast<int>(world().map->data[cell]), 0) << x << ", " << y;
    EXPECT_GE(static_cast<int>(world().probability->data[cell]), 0) << x << ", " << y;
    EXPECT_LE(static_cast<int>(world().probability->data[cell]), 2) << x << ", " << y;
  }
}

TEST_F(Mapping, CostsBelongToTheMap) {
  ASSERT_TRUE(world().map && world().costs);
  EXPECT_EQ(world().costs->info, world().map->info);
  ASSERT_EQ(world().costs->data.size(), world().map->data.size());
  for (std::size_t i = 0; i < world().map->data.size(); ++i) {
    const int state = world().map->data[i];
    const int cost = world().costs->data[i];
    ASSERT_TRUE(state == 0 ? cost >= 0 && cost < 100 : cost == state) << state << ": " << cost;
  }
  EXPECT_GT(count(*world().costs, 99), 0U) << "no free cell is near the rim";
}

TEST_F(Mapping, DynamicMapIsTheTopicsMap) {
  nav_msgs::GetMap call;
  ASSERT_TRUE(callService("dynamic_map", call));
  ASSERT_NE(world().map, nullptr);
  EXPECT_EQ(call.response.map.header.frame_id, world().map->header.frame_id);
  EXPECT_EQ(call.response.map.info, world().map->info);
  EXPECT_EQ(call.response.map.data, world().map->data);
  EXPECT_TRUE(world().consumers->layer().accept(call.response.map));
}

void expectTheMap(const octomap_msgs::Octomap& message, bool binary) {
  EXPECT_EQ(message.binary != 0, binary);
  EXPECT_EQ(message.header.frame_id, Mapping::world().map->header.frame_id);
  const auto tree = OctomapReader::read(message);
  ASSERT_NE(tree, nullptr);
  OctomapReader::expectSame(*tree, *Mapping::world().map);
  const auto floor = OctomapReader::columnsAt(*tree, 0);
  const double resolution = tree->getResolution();
  const auto top = [&](const char* height) {
    return static_cast<int>(
        std::lround(ros::param::param(Mapping::mapper() + "/octomap/" + height, 0.0) / resolution));
  };
  EXPECT_EQ(OctomapReader::columnsAt(*tree, top("wall_height") - 1).first, floor.first);
  EXPECT_TRUE(OctomapReader::columnsAt(*tree, top("wall_height")).first.empty());
  EXPECT_EQ(OctomapReader::columnsAt(*tree, top("robot_height") - 1).second, floor.second);
  EXPECT_TRUE(OctomapReader::columnsAt(*tree, top("robot_height")).second.empty());
}

TEST_F(Mapping, TheOctomapTopicsHoldTheMap) {
  ASSERT_TRUE(spinUntil([] { return world().binary && world().full; }, 30.0));
  expectTheMap(*world().binary, true);
  expectTheMap(*world().full, false);
}

TEST_F(Mapping, TheOctomapServicesHoldTheMap) {
  waitUntilQuiet();  // the services answer with the newest map
  octomap_msgs::GetOctomap binary, full;
  ASSERT_TRUE(callService("octomap_binary", binary));
  ASSERT_TRUE(callService("octomap_full", full));
  expectTheMap(binary.response.map, true);
  expectTheMap(full.response.map, false);
}

TEST_F(Mapping, RvizCanShowTheMarkers) {
  ASSERT_NE(world().markers, nullptr);
  std::set<std::pair<std::string, int>> names;
  std::set<std::string> groups;
  for (const visualization_msgs::Marker& marker : world().markers->markers) {
    EXPECT_EQ(marker.header.frame_id, world().map->header.frame_id);
    if (marker.action == visualization_msgs::Marker::DELETEALL) {
      continue;
    }
    EXPECT_TRUE(names.emplace(marker.ns, marker.id).second) << marker.ns << " " << marker.id;
    groups.insert(marker.ns);
    EXPECT_GT(marker.scale.z, 0.0);
    EXPECT_GT(marker.color.a, 0.0F);
    EXPECT_EQ(marker.pose.orientation.w, 1.0);
    EXPECT_TRUE(std::isfinite(marker.pose.position.x + marker.pose.position.y));
    EXPECT_TRUE(marker.colors.empty() || marker.colors.size() == marker.points.size());
    EXPECT_EQ(marker.type == visualization_msgs::Marker::TEXT_VIEW_FACING, !marker.text.empty());
  }
  for (const char* group : {"access_points", "names", "path", "legend"}) {
    EXPECT_EQ(groups.count(group), 1U) << group;
  }
}

TEST_F(Mapping, ThePathIsThatOfTheRobot) {
  ASSERT_NE(world().path, nullptr);
  EXPECT_EQ(world().path->header.frame_id, world().map->header.frame_id);
  ASSERT_GT(world().path->poses.size(), 10U);
  ros::Time last;
  for (const geometry_msgs::PoseStamped& pose : world().path->poses) {
    EXPECT_EQ(pose.header.frame_id, world().path->header.frame_id);
    EXPECT_LE(last, pose.header.stamp);
    EXPECT_TRUE(std::isfinite(pose.pose.position.x + pose.pose.position.y));
    EXPECT_EQ(pose.pose.orientation.w, 1.0);
    last = pose.header.stamp;
  }
}

TEST_F(Mapping, TheWallsAndTheirLossBelongToTheMap) {
  ASSERT_NE(world().walls, nullptr);
  EXPECT_EQ(world().walls->header.frame_id, world().map->header.frame_id);
  EXPECT_EQ(world().walls->header.stamp, world().map->header.stamp);
  ASSERT_NE(world().wall_loss, nullptr);
  EXPECT_EQ(world().wall_loss->info, world().map->info);
  for (const structure_from_wifi::Wall& wall : world().walls->walls) {
    EXPECT_GT(wall.confidence, 0.0F);
    EXPECT_LT(wall.confidence, 1.0F);
  }
}

TEST_F(Mapping, SavesTheMap) {
  const auto response = save("first");
  ASSERT_TRUE(response.success) << response.message;
  waitUntilQuiet();
  for (const char* file :
       {"map.yaml", "map.pgm", "probability.yaml", "probability.pgm", "probability.png",
        "costs.yaml", "costs.png", "map.bt", "map.ot", "map.png", "report.json", "readings.csv",
        "access_points.yaml", "walls.yaml", "walls.svg", "walls.dxf"}) {
    EXPECT_TRUE(fs::file_size(saveDirectory() / "first" / file) > 0) << file;
  }
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary((saveDirectory() / "first" / "map.bt").string()));
  OctomapReader::expectSame(tree, *world().map);
}

TEST_F(Mapping, SavesNowhereElse) {
  const auto before = contentOf(saveDirectory().parent_path());
  for (const std::string& name :
       {std::string("../x"), std::string(), std::string(";id;"), std::string(300, 'a'),
        std::string(".."), std::string("."), std::string("/tmp/x"), std::string("a/b"),
        std::string("$(id)"), std::string("a\nb"), std::string("a\0b", 3)}) {
    const auto response = save(name);
    EXPECT_FALSE(response.success) << name;
    EXPECT_FALSE(response.message.empty()) << name;
  }
  EXPECT_EQ(contentOf(saveDirectory().parent_path()), before);
}

TEST_F(Mapping, LeavesAloneWhatItCannotReplace) {
  std::ofstream(saveDirectory() / "file") << "mine";
  fs::create_directories(saveDirectory() / "held" / "readings.csv");
  std::ofstream(saveDirectory() / "held" / "map.pgm") << "old";
  const auto before = contentOf(saveDirectory());
  for (const char* name : {"file", "held"}) {
    const auto response = save(name);
    EXPECT_FALSE(response.success) << name;
    EXPECT_NE(response.message.find((saveDirectory() / name).string()), std::string::npos)
        << response.message;
  }
  EXPECT_EQ(contentOf(saveDirectory()), before);
}

TEST_F(Mapping, AResetForgetsEverythingButTheGeometry) {
  waitUntilQuiet();
  ASSERT_TRUE(spinUntil([] { return world().map != nullptr; }, 30.0));
  const auto kept = contentOf(saveDirectory() / "first");
  ASSERT_FALSE(kept.empty()) << "SavesTheMap comes before";
  const nav_msgs::MapMetaData info = world().map->info;
  world().consumers->layer().holdGeometry();
  world().map.reset();
  world().binary.reset();
  std_srvs::Trigger call;
  ASSERT_TRUE(callService(mapper() + "/reset", call));
  EXPECT_TRUE(call.response.success);
  ASSERT_TRUE(spinUntil([] { return world().map && world().binary; }, 30.0));
  EXPECT_EQ(world().map->info.width, info.width);
  EXPECT_EQ(world().map->info.height, info.height);
  EXPECT_EQ(world().map->info.resolution, info.resolution);
  EXPECT_EQ(world().map->info.origin, info.origin);
  EXPECT_EQ(count(*world().map, -1), world().map->data.size());
  const auto tree = OctomapReader::read(*world().binary);
  ASSERT_NE(tree, nullptr);
  EXPECT_EQ(tree->size(), 0U);
  for (const char* name : {"first", "empty"}) {
    const auto response = save(name);
    EXPECT_FALSE(response.success) << name;
    EXPECT_NE(response.message.find("there are no readings yet"), std::string::npos);
  }
  EXPECT_EQ(contentOf(saveDirectory() / "first"), kept);
  EXPECT_FALSE(fs::exists(saveDirectory() / "empty"));
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "mapping_launch_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
