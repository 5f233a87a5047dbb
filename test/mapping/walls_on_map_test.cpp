#include "mapping/walls_on_map.h"

#include <gtest/gtest.h>

#include "base/constants.h"
#include "grid/for_each_cell.h"

namespace sfw {
namespace {

const GridGeometry kBuilding(0.1, {0.0, 0.0}, 40, 30);  // what the network sees
const GridGeometry kMap(0.05, {0.0, 0.0}, 80, 60);

/// A wall along y = 1.05 m, from x = 0.55 to 3.45 m.
StripWall wallAcross(bool is_outer = false) {
  StripWall wall;
  for (std::int64_t x = 5; x < 35; ++x) {
    wall.cells.push_back({x, 10});
  }
  wall.is_outer = is_outer;
  return wall;
}

/// The columns of the cells that are wall. All lie in the same row.
std::vector<std::int64_t> columnsOf(const Mask& walls, std::int64_t row) {
  std::vector<std::int64_t> columns;
  forEachCell(walls.geometry, [&](Cell c) {
    if (walls[c] != 0) {
      EXPECT_EQ(c.y, row);
      columns.push_back(c.x);
    }
  });
  return columns;
}

std::vector<std::int64_t> range(std::int64_t first, std::int64_t last) {
  std::vector<std::int64_t> numbers;
  for (; first <= last; ++first) {
    numbers.push_back(first);
  }
  return numbers;
}

TEST(WallsOnMap, AreOneCellThick) {
  const Mask walls = wallsOnMap({wallAcross()}, kBuilding, {}, Mask(kMap));
  EXPECT_EQ(columnsOf(walls, 21), range(11, 69));
}

TEST(WallsOnMap, EndBeforeTheWayOfTheRobot) {
  Mask open(kMap);
  forEachCell({36, 0}, {43, 59}, [&](Cell c) { open[c] = 1; });
  std::vector<std::int64_t> expected = range(11, 32);  // 15 cm are three cells
  for (const std::int64_t column : range(47, 69)) {
    expected.push_back(column);
  }
  EXPECT_EQ(columnsOf(wallsOnMap({wallAcross()}, kBuilding, {}, open), 21), expected);
}

TEST(WallsOnMap, KeepTheirDistanceFromADoorAtTheirEnd) {
  Mask open(kMap);
  forEachCell({71, 0}, {79, 59}, [&](Cell c) { open[c] = 1; });  // 5 cm beyond the last cell
  EXPECT_EQ(columnsOf(wallsOnMap({wallAcross()}, kBuilding, {}, open), 21), range(11, 67));
}

TEST(WallsOnMap, StandBesideAWayThatDoesNotCrossThem) {
  Mask open(kMap);
  forEachCell({0, 22}, {79, 30}, [&](Cell c) { open[c] = 1; });
  EXPECT_EQ(columnsOf(wallsOnMap({wallAcross()}, kBuilding, {}, open), 21), range(11, 69));
}

TEST(WallsOnMap, LeaveOutOuterWallsAndCellsBeyondTheMap) {
  EXPECT_TRUE(columnsOf(wallsOnMap({wallAcross(true)}, kBuilding, {}, Mask(kMap)), 21).empty());
  const Mask small(GridGeometry(0.05, {1.0, 0.0}, 20, 60));
  EXPECT_EQ(columnsOf(wallsOnMap({wallAcross()}, kBuilding, {}, small), 21), range(0, 19));
}

TEST(WallsOnMap, TurnWithTheBuilding) {
  BuildingFrame frame;
  frame.yaw_rad = 0.5 * kPi;                             // x of the building is y of the map
  const GridGeometry map(0.05, {-2.02, -0.02}, 40, 80);  // the wall is on no border of cells
  const Mask walls = wallsOnMap({wallAcross()}, kBuilding, frame, Mask(map));
  std::vector<std::int64_t> rows;
  forEachCell(map, [&](Cell c) {
    if (walls[c] != 0) {
      EXPECT_NEAR(map.centre(c).x(), -1.05, 0.05);
      rows.push_back(c.y);
    }
  });
  EXPECT_EQ(rows, range(rows.front(), rows.front() + 58));
}

}  // namespace
}  // namespace sfw
