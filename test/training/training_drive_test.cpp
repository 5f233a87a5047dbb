#include "training/training_drive.h"

#include <gtest/gtest.h>

#include "support/ascii_world.h"

namespace sfw::test {
namespace {

using Rows = std::vector<std::string>;

/// Labels of the cells of a picture with cells of half a metre, seen from the middle of some cells.
Rows labelsFrom(const std::vector<Cell>& path, const Rows& rows) {
  const Grid<CellState> states = world(rows, 0.5);
  std::vector<Position> positions;
  for (const Cell c : path) {
    positions.push_back(states.geometry.centre(c));
  }
  return rowsOf(visibleStates(positions, states));
}

const Rows kTwoRooms{"#######",  //
                     "#..#..#",  //
                     "#..#..#",  //
                     "#..#..#",  //
                     "#..#..#",  //
                     "#..#..#",  //
                     "#######"};

TEST(VisibleStates, LabelsTheRoomOfThePathAndItsWalls) {
  EXPECT_EQ(labelsFrom({{1, 3}}, kTwoRooms), (Rows{"####???",  //
                                                   "#..#???",  //
                                                   "#..#???",  //
                                                   "#..#???",  //
                                                   "#..#???",  //
                                                   "#..#???",  //
                                                   "####???"}));
}

TEST(VisibleStates, LooksFromEachPlaceOfThePath) {
  EXPECT_EQ(labelsFrom({{1, 3}, {5, 3}}, kTwoRooms), kTwoRooms);
}

TEST(VisibleStates, LooksFromPlacesAtLeastEightyCentimetresApart) {
  // From the second place one could see around the corner; it is half a metre from the first.
  const Rows corner{"....", "..#.", "..#.", "..#."};
  const Rows from_first = labelsFrom({{0, 0}}, corner);
  EXPECT_EQ(labelsFrom({{0, 0}, {0, 1}}, corner), from_first);
  EXPECT_NE(labelsFrom({{0, 0}, {0, 3}}, corner), from_first);
}

TEST(VisibleStates, LabelsWallsTwoCellsDeep) {
  EXPECT_EQ(labelsFrom({{1, 1}}, {"...####", "...####", "...####"}),
            (Rows{"...##??", "...##??", "...##??"}));
}

TEST(VisibleStates, LooksFromFreeCellsOnTheGridOnly) {
  const Rows nothing(7, "???????");
  EXPECT_EQ(labelsFrom({{3, 3}}, kTwoRooms), nothing) << "inside a wall";
  EXPECT_EQ(labelsFrom({{-1, 3}, {9, 3}}, kTwoRooms), nothing);
  EXPECT_EQ(labelsFrom({}, kTwoRooms), nothing);
}

TEST(VisibleStates, LeavesUnknownCellsUnknown) {
  EXPECT_EQ(labelsFrom({{1, 1}}, {"....", "..?.", "...."})[1][2], '?');
}

}  // namespace
}  // namespace sfw::test
