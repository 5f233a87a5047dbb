#include "grid/axis_rasters.h"

#include <gtest/gtest.h>

#include "support/ascii_world.h"
#include "support/number_table.h"

namespace sfw::test {
namespace {

using Rows = std::vector<std::string>;

Grid<float> digits(const Rows& rows) {
  return gridFrom<float>(rows, 1.0, [](char c) { return static_cast<float>(c - '0'); });
}

const Rows kNumbers{"0000000",  //
                    "0000000",  //
                    "0009000",  //
                    "0000000",  //
                    "0000000",  //
                    "0000000",  //
                    "9000000"};

TEST(AxisRasters, RowMeanIsThatOfThreeNeighboursInARow) {
  expectTable(rowMean(digits(kNumbers), 1), {{0, 0, 0, 0, 0, 0, 0},
                                             {0, 0, 0, 0, 0, 0, 0},
                                             {0, 0, 3, 3, 3, 0, 0},
                                             {0, 0, 0, 0, 0, 0, 0},
                                             {0, 0, 0, 0, 0, 0, 0},
                                             {0, 0, 0, 0, 0, 0, 0},
                                             {3, 3, 0, 0, 0, 0, 0}});
}

TEST(AxisRasters, ColumnMeanIsThatOfThreeNeighboursInAColumn) {
  expectTable(columnMean(digits(kNumbers), 1), {{0, 0, 0, 0, 0, 0, 0},
                                                {0, 0, 0, 3, 0, 0, 0},
                                                {0, 0, 0, 3, 0, 0, 0},
                                                {0, 0, 0, 3, 0, 0, 0},
                                                {0, 0, 0, 0, 0, 0, 0},
                                                {3, 0, 0, 0, 0, 0, 0},
                                                {3, 0, 0, 0, 0, 0, 0}});
}

TEST(AxisRasters, BoxMeanIsThatOfASquare) {
  expectTable(boxMean(digits(kNumbers), 1), {{0, 0, 0, 0, 0, 0, 0},
                                             {0, 0, 1, 1, 1, 0, 0},
                                             {0, 0, 1, 1, 1, 0, 0},
                                             {0, 0, 1, 1, 1, 0, 0},
                                             {0, 0, 0, 0, 0, 0, 0},
                                             {1, 1, 0, 0, 0, 0, 0},
                                             {1, 1, 0, 0, 0, 0, 0}});
}

TEST(AxisRasters, BoxMeanCountsCellsBeyondTheGridAsZero) {
  const Grid<float> ones(GridGeometry(0.1, {0.0, 0.0}, 7, 7), 1.0F);
  constexpr double k2 = 15.0 / 25.0, k3 = 9.0 / 25.0, k1 = 20.0 / 25.0, k4 = 12.0 / 25.0;
  constexpr double k5 = 16.0 / 25.0;
  expectTable(boxMean(ones, 2), {{k3, k4, k2, k2, k2, k4, k3},
                                 {k4, k5, k1, k1, k1, k5, k4},
                                 {k2, k1, 1, 1, 1, k1, k2},
                                 {k2, k1, 1, 1, 1, k1, k2},
                                 {k2, k1, 1, 1, 1, k1, k2},
                                 {k4, k5, k1, k1, k1, k5, k4},
                                 {k3, k4, k2, k2, k2, k4, k3}});
  expectTable(boxMean(ones, 0), Table(7, std::vector<double>(7, 1.0)));
}

// ---- Distances along the axes ----

/// Cells of half a metre.
const Grid<std::uint8_t> kTwoCells =
    gridFrom<std::uint8_t>({".......",  //
                            "..#....",  //
                            ".......",  //
                            ".......",  //
                            "..#..#.",  //
                            ".......",  //
                            "......."},
                           0.5, [](char c) -> std::uint8_t { return c == '#'; });

TEST(AxisDistances, ToTheLeftAreThoseToTheNearestCellThere) {
  expectTable(axisDistances(kTwoCells, 1.2F)[0], {{1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 0.0, 0.5, 1.0, 1.2, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 0.0, 0.5, 1.0, 0.0, 0.5},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2}});
}

TEST(AxisDistances, ToTheRightAreThoseToTheNearestCellThere) {
  expectTable(axisDistances(kTwoCells, 1.2F)[1], {{1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.0, 0.5, 0.0, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.0, 0.5, 0.0, 1.0, 0.5, 0.0, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2}});
}

TEST(AxisDistances, DownAreThoseToTheNearestCellBelow) {
  expectTable(axisDistances(kTwoCells, 1.2F)[2], {{1.2, 1.2, 0.5, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 0.0, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.0, 1.2, 1.2, 1.0, 1.2},
                                                  {1.2, 1.2, 0.5, 1.2, 1.2, 0.5, 1.2},
                                                  {1.2, 1.2, 0.0, 1.2, 1.2, 0.0, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2}});
}

TEST(AxisDistances, UpAreThoseToTheNearestCellAbove) {
  expectTable(axisDistances(kTwoCells, 1.2F)[3], {{1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 0.0, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 0.5, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 1.0, 1.2, 1.2, 1.2, 1.2},
                                                  {1.2, 1.2, 0.0, 1.2, 1.2, 0.0, 1.2},
                                                  {1.2, 1.2, 0.5, 1.2, 1.2, 0.5, 1.2},
                                                  {1.2, 1.2, 1.0, 1.2, 1.2, 1.0, 1.2}});
}

// ---- Closing with a square ----

TEST(ClosedWithSquare, ClosesGapsInWhichTheSquareFindsNoRoom) {
  const Mask gaps = mask({"..........",  //
                          "..........",  //
                          "..#..#....",  // two cells
                          "..#..#....",  //
                          "..#..#....",  //
                          "..........",  //
                          ".........."});
  EXPECT_EQ(rowsOf(closedWithSquare(gaps, 1)), (Rows{"..........",  //
                                                     "..........",  //
                                                     "..####....",  //
                                                     "..####....",  //
                                                     "..####....",  //
                                                     "..........",  //
                                                     ".........."}));
  const Mask wider = mask({"..........",  //
                           "..........",  //
                           "..#...#...",  // three
                           "..#...#...",  //
                           "..#...#...",  //
                           "..........",  //
                           ".........."});
  EXPECT_EQ(rowsOf(closedWithSquare(wider, 1)), rowsOf(wider));
}

TEST(ClosedWithSquare, KeepsSquareCorners) {
  const Mask corner = mask({".......",  //
                            ".......",  //
                            "..###..",  //
                            "..#....",  //
                            "..#....",  //
                            ".......",  //
                            "......."});
  EXPECT_EQ(rowsOf(closedWithSquare(corner, 1)), rowsOf(corner)) << "a square fits into it";
}

TEST(ClosedWithSquare, ClosesTheGapToAnEdgeOfTheGridToo) {
  // No square is put where it would have its middle beyond the edge.
  const Mask near = mask({".......",  //
                          ".#.....",  //
                          ".#.....",  //
                          ".#.....",  //
                          ".#.....",  //
                          ".#.....",  //
                          "......."});
  EXPECT_EQ(rowsOf(closedWithSquare(near, 1)), (Rows{"##.....",  //
                                                     "##.....",  //
                                                     "##.....",  //
                                                     "##.....",  //
                                                     "##.....",  //
                                                     "##.....",  //
                                                     "##....."}));
}

TEST(ClosedWithSquare, LeavesAnEmptySetEmpty) {
  const Mask nothing(GridGeometry(1.0, {0.0, 0.0}, 7, 7));
  EXPECT_EQ(closedWithSquare(nothing, 2).cells, nothing.cells);
}

}  // namespace
}  // namespace sfw::test
