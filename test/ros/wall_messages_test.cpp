// Walls and their losses as messages and markers.

#include <gtest/gtest.h>
#include <ros/message_traits.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ros/conversion/markers.h"
#include "ros/conversion/message_conversion.h"

namespace sfw {
namespace {

const std::vector<WallSegment> kWalls{{{1.0, 2.0}, {1.0, 3.5}, 0.6},
                                      {{-4.0, 0.5}, {2.0, 0.5}, 0.9, true}};

std_msgs::Header header() {
  std_msgs::Header header;
  header.frame_id = "floor";
  header.stamp = ros::Time(12.0);
  return header;
}

Snapshot snapshotWith(const std::vector<WallSegment>& walls) {
  const BeliefMap belief(GridGeometry(0.1, {-5.0, 0.0}, 100, 50), {});
  Snapshot snapshot{belief, belief, {}, {}, {}};
  snapshot.walls = walls;
  return snapshot;
}

void expectPoint(const geometry_msgs::Point& point, const Position& position) {
  EXPECT_EQ(point.x, position.x());
  EXPECT_EQ(point.y, position.y());
}

/// The markers of a namespace.
std::vector<visualization_msgs::Marker> markersIn(const std::string& name,
                                                  const Snapshot& snapshot) {
  std::vector<visualization_msgs::Marker> found;
  for (const visualization_msgs::Marker& marker : toMarkers(snapshot, {}, header()).markers) {
    if (marker.ns == name) {
      found.push_back(marker);
    }
  }
  return found;
}

TEST(WallMessages, HoldEachSegmentOnTheFloor) {
  const structure_from_wifi::Walls message = toWalls(snapshotWith(kWalls), header());
  EXPECT_TRUE(ros::message_traits::hasHeader<structure_from_wifi::Walls>());
  EXPECT_EQ(message.header, header());
  ASSERT_EQ(message.walls.size(), kWalls.size());
  for (std::size_t i = 0; i < kWalls.size(); ++i) {
    expectPoint(message.walls[i].start, kWalls[i].from);
    expectPoint(message.walls[i].end, kWalls[i].to);
    EXPECT_EQ(message.walls[i].start.z, 0.0);
    EXPECT_EQ(message.walls[i].end.z, 0.0);
    EXPECT_FLOAT_EQ(message.walls[i].confidence, static_cast<float>(kWalls[i].confidence));
    EXPECT_EQ(message.walls[i].outer, kWalls[i].is_outer);
  }
}

TEST(WallMessages, AreEmptyForAMapWithoutWalls) {
  EXPECT_TRUE(toWalls(snapshotWith({}), header()).walls.empty());
  EXPECT_TRUE(markersIn("walls", snapshotWith({})).empty());
}

TEST(WallMarkers, AreLinesWhoseOpacityIsTheConfidence) {
  const auto markers = markersIn("walls", snapshotWith(kWalls));
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].type, visualization_msgs::Marker::LINE_LIST);
  EXPECT_EQ(markers[0].header.frame_id, "floor");
  ASSERT_EQ(markers[0].points.size(), 2 * kWalls.size());
  ASSERT_EQ(markers[0].colors.size(), 2 * kWalls.size());
  for (std::size_t i = 0; i < kWalls.size(); ++i) {
    expectPoint(markers[0].points[2 * i], kWalls[i].from);
    expectPoint(markers[0].points[2 * i + 1], kWalls[i].to);
    EXPECT_FLOAT_EQ(markers[0].colors[2 * i].a, static_cast<float>(kWalls[i].confidence));
    EXPECT_FLOAT_EQ(markers[0].colors[2 * i + 1].a, static_cast<float>(kWalls[i].confidence));
  }
}

TEST(WallMarkers, OuterWallsArePaler) {
  const auto markers = markersIn("walls", snapshotWith(kWalls));
  ASSERT_EQ(markers.size(), 1U);
  ASSERT_EQ(markers[0].colors.size(), 4U);
  for (std::size_t end = 0; end < 2; ++end) {
    const std_msgs::ColorRGBA& wall = markers[0].colors[end];
    const std_msgs::ColorRGBA& outer_wall = markers[0].colors[2 + end];
    EXPECT_GT(outer_wall.r, wall.r + 0.2F);
    EXPECT_GT(outer_wall.g, wall.g + 0.2F);
    EXPECT_GT(outer_wall.b, wall.b + 0.2F);
  }
}

TEST(WallLossMessage, HoldsFiftyStepsADecibelUpToAHundred) {
  Grid<float> wall_loss(GridGeometry(0.5, {1.0, 2.0}, 3, 2));
  wall_loss.cells = {0.0F, 0.5F, 1.0F, 2.0F, 2.5F, 200.0F};
  const nav_msgs::OccupancyGrid grid = toWallLossGrid(wall_loss, header());
  EXPECT_EQ(grid.header, header());
  EXPECT_EQ(grid.info.width, 3U);
  EXPECT_EQ(grid.info.height, 2U);
  EXPECT_EQ(grid.data, (std::vector<std::int8_t>{0, 25, 50, 100, 100, 100}));
}

}  // namespace
}  // namespace sfw
