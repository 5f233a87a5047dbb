#include "k_visibility/k_visibility.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"
#include "structure_from_wifi/input_error.h"
#include "support/ascii_world.h"
#include "support/k_visibility_checks.h"

namespace sfw {
namespace {

using test::agreement;
using test::inverseFigures;
using test::InverseFigures;
using test::radioCount;
using test::runsOfWall;

using Rows = std::vector<std::string>;

/// Counts as digits, '#' wall, '?' no count.
Rows rowsOf(const Grid<std::uint8_t>& k_map) {
  return test::rowsOf(k_map, [](std::uint8_t k) {
    return k == kWallCell ? '#' : k == kNoCount ? '?' : static_cast<char>('0' + k);
  });
}

/// The k map of a picture in cells of 1 m; 'R' is the access point, on free ground.
Rows countsIn(Rows rows) {
  Position access_point = Position::Zero();
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const std::size_t x = rows[row].find('R');
    if (x != std::string::npos) {
      access_point = {static_cast<double>(x) + 0.5, static_cast<double>(rows.size() - row) - 0.5};
      rows[row][x] = '.';
    }
  }
  return rowsOf(forwardKVisibility(test::world(rows, 1.0), access_point));
}

// ---- Forward: pictures ----

TEST(ForwardKVisibility, CountsWallsOneCellThick) {
  EXPECT_EQ(countsIn({"R..#..#..#.."}), Rows({"000#11#22#33"}));
  EXPECT_EQ(countsIn({"..#..R..#.#."}), Rows({"11#00000#1#2"}));
}

TEST(ForwardKVisibility, CountsThickWallsOnce) {
  EXPECT_EQ(countsIn({"R.##..####.."}), Rows({"00##11####22"}));
  EXPECT_EQ(countsIn({"......",  //
                      "..##..",  //
                      "R.##..",  //
                      "..##..",  //
                      "......"}),
            Rows({"000111",  // the ray to the fourth cell clips the wall's corner
                  "00##11",  //
                  "00##11",  //
                  "00##11",  //
                  "000111"}));
}

TEST(ForwardKVisibility, RoomsAroundARoom) {
  EXPECT_EQ(countsIn({"...........",  //
                      ".#########.",  //
                      ".#.......#.",  //
                      ".#.#####.#.",  //
                      ".#.#...#.#.",  //
                      ".#.#.R.#.#.",  //
                      ".#.#...#.#.",  //
                      ".#.#####.#.",  //
                      ".#.......#.",  //
                      ".#########.",  //
                      "..........."}),
            Rows({"22222222222",  //
                  "2#########2",  //
                  "2#1111111#2",  //
                  "2#1#####1#2",  //
                  "2#1#000#1#2",  //
                  "2#1#000#1#2",  //
                  "2#1#000#1#2",  //
                  "2#1#####1#2",  //
                  "2#1111111#2",  //
                  "2#########2",  //
                  "22222222222"}));
}

TEST(ForwardKVisibility, LooksThroughADoor) {
  EXPECT_EQ(countsIn({"....#....",  //
                      "....#....",  //
                      "R........",  //
                      "....#....",  //
                      "....#...."}),
            Rows({"0000#1111",  //
                  "0000#1111",  //
                  "000000000",  //
                  "0000#1111",  //
                  "0000#1111"}));
}

TEST(ForwardKVisibility, UnknownCellsAreNoWallAndGetNoCount) {
  EXPECT_EQ(countsIn({"R.??.#?.#."}), Rows({"00??0#?1#2"}));
}

TEST(ForwardKVisibility, AnAccessPointInAWallHearsThroughItForNothing) {
  const Rows rows{"..##..#."};
  EXPECT_EQ(rowsOf(forwardKVisibility(test::world(rows, 1.0), {2.5, 0.5})), Rows({"00##00#1"}));
  EXPECT_EQ(rowsOf(forwardKVisibility(test::world(rows, 1.0), {3.5, 0.5})), Rows({"00##00#1"}));
}

TEST(ForwardKVisibility, AnAccessPointMayLieOutsideTheGrid) {
  const Grid<CellState> plan = test::world({"..#..#.", "#.#.##.", ".......", "?.#..#."}, 1.0);
  const auto from_left = forwardKVisibility(plan, {-100.0, 0.5});
  EXPECT_EQ(rowsOf(from_left)[3], "?0#11#2");
  const auto from_above = forwardKVisibility(plan, {0.5, 50.0});
  EXPECT_EQ(rowsOf(from_above)[0][0], '0');
  EXPECT_EQ(rowsOf(from_above)[2][0], '1');
}

TEST(ForwardKVisibility, CountsStayAtTheirLimit) {
  std::string row = "R";
  for (int i = 0; i < 300; ++i) {
    row += "#.";
  }
  const std::string counts = countsIn({row})[0];
  EXPECT_EQ(counts[2 * 249], static_cast<char>('0' + 249));
  EXPECT_EQ(counts[2 * 250], static_cast<char>('0' + kMostWalls));
  EXPECT_EQ(counts[2 * 299], static_cast<char>('0' + kMostWalls));
}

TEST(ForwardKVisibility, AMirroredPlanGivesMirroredCounts) {
  const Rows rows{"....#...#..",  //
                  ".##.#.#.#..",  //
                  "..........#",  //
                  "#.##...#..."};
  Rows mirrored = rows;
  for (std::string& row : mirrored) {
    std::reverse(row.begin(), row.end());
  }
  Rows counts = rowsOf(forwardKVisibility(test::world(rows, 1.0), {3.3, 1.6}));
  for (std::string& row : counts) {
    std::reverse(row.begin(), row.end());
  }
  EXPECT_EQ(rowsOf(forwardKVisibility(test::world(mirrored, 1.0), {11.0 - 3.3, 1.6})), counts);
}

// ---- Forward against rays ----

/// A flat with rooms and doors, in cells of 0.05 m.
Grid<CellState> flat() {
  Grid<CellState> plan(GridGeometry(0.05, {-2.0, 1.0}, 200, 160), CellState::kFree);
  const auto build = [&plan](std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
                             CellState state) {
    Cell c;
    for (c.y = y0; c.y < y1; ++c.y) {
      for (c.x = x0; c.x < x1; ++c.x) {
        plan[c] = state;
      }
    }
  };
  build(0, 0, 200, 6, CellState::kOccupied);
  build(0, 154, 200, 160, CellState::kOccupied);
  build(0, 0, 6, 160, CellState::kOccupied);
  build(194, 0, 200, 160, CellState::kOccupied);
  build(70, 0, 73, 160, CellState::kOccupied);
  build(130, 0, 132, 160, CellState::kOccupied);
  build(0, 80, 200, 82, CellState::kOccupied);
  build(70, 30, 73, 48, CellState::kFree);  // doors
  build(130, 100, 132, 118, CellState::kFree);
  build(20, 80, 38, 82, CellState::kFree);
  build(150, 80, 168, 82, CellState::kFree);
  return plan;
}

/// In rooms, behind walls, in the outer wall and outside the grid.
const std::vector<Position> kFlatPlaces{{-1.0, 2.1}, {2.513, 4.021}, {7.1, 8.2},
                                        {1.57, 3.3}, {-1.9, 5.3},    {-4.0, 5.3}};

TEST(ForwardKVisibility, AgreesWithRaysInAFlat) {
  for (const Position& access_point : kFlatPlaces) {
    EXPECT_GE(agreement(flat(), access_point, runsOfWall), 0.995) << access_point.transpose();
  }
}

TEST(ForwardKVisibility, IsWhatTheRadioCounts) {
  for (const Position& access_point : kFlatPlaces) {
    EXPECT_EQ(agreement(flat(), access_point, radioCount), 1.0) << access_point.transpose();
  }
}

/// A tenth wall, a tenth unknown.
Grid<CellState> scattered() {
  Grid<CellState> plan(GridGeometry(0.125, {1.0, -3.0}, 90, 70), CellState::kFree);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    const double share = Random(1, 1, i).uniform();
    plan.cells[i] = share < 0.1   ? CellState::kOccupied
                    : share < 0.2 ? CellState::kUnknown
                                  : CellState::kFree;
  }
  return plan;
}

TEST(ForwardKVisibility, IsWhatTheRadioCountsThroughCornersToo) {
  // From a cell's centre or corner every third ray passes exactly through other corners.
  const Grid<CellState> plan = scattered();
  for (const Position& cells :
       {Position(20.5, 30.5), Position(21.0, 33.0), Position(0.5, 0.5), Position(90.5, 12.5),
        Position(-7.5, 33.5), Position(44.5, -20.5), Position(-60.5, -40.5)}) {
    const Position access_point = plan.geometry.origin() + 0.125 * cells;
    EXPECT_EQ(agreement(plan, access_point, radioCount), 1.0) << cells.transpose();
  }
}

TEST(ForwardKVisibility, TwoWallsThatMeetInACornerLeaveNoGap) {
  EXPECT_EQ(countsIn({"....#",  //
                      "...#.",  //
                      "..#..",  //
                      ".#...",  //
                      "#...R"}),
            Rows({"1111#",  //
                  "111#0",  //
                  "11#00",  //
                  "1#000",  //
                  "#0000"}));
}

TEST(ForwardKVisibility, RefusesWhatItCannotCountExactly) {
  const Grid<CellState> plan = test::world({"..#.."}, 1.0);
  EXPECT_EQ(rowsOf(forwardKVisibility(plan, {-524288.0, 0.5})), Rows({"00#11"}));
  EXPECT_THROW(forwardKVisibility(plan, {-524289.0, 0.5}), InputError);
  EXPECT_THROW(forwardKVisibility(plan, {0.5, 1e300}), InputError);
}

TEST(ForwardKVisibility, AgreesWithRaysAmongScatteredCells) {
  for (const Position& access_point : {Position(4.213, 0.377), Position(11.96, 3.91)}) {
    EXPECT_GE(agreement(scattered(), access_point, runsOfWall), 0.995) << access_point.transpose();
  }
}

// ---- Inverse ----

TEST(DenseInverseKVisibility, FindsTheWallsItLooksThrough) {
  const Rows rows{".........",  //
                  ".#####.#.",  //
                  ".#...#.#.",  //
                  ".#...#.#.",  //
                  ".#...#.#.",  //
                  ".#####.#.",  //
                  "........."};
  const Grid<CellState> plan = test::world(rows, 1.0);
  const Position access_point(3.5, 3.5);
  EXPECT_EQ(
      test::rowsOf(denseInverseKVisibility(forwardKVisibility(plan, access_point), access_point)),
      rows);
}

TEST(DenseInverseKVisibility, WallsThatNothingIsBehindStayUnknown) {
  const Grid<CellState> plan = test::world({"....#?"}, 1.0);
  const Position access_point(0.5, 0.5);
  EXPECT_EQ(
      test::rowsOf(denseInverseKVisibility(forwardKVisibility(plan, access_point), access_point)),
      Rows({"....??"}));
}

TEST(DenseInverseKVisibility, ReadsMapsThatMarkNoWalls) {
  Grid<std::uint8_t> k_map = forwardKVisibility(test::world({"...#..##.."}, 1.0), {0.5, 0.5});
  std::replace(k_map.cells.begin(), k_map.cells.end(), kWallCell, kNoCount);
  EXPECT_EQ(test::rowsOf(denseInverseKVisibility(k_map, {0.5, 0.5})), Rows({"...#..##.."}));
}

TEST(DenseInverseKVisibility, AMapWithoutCountsHasNoWalls) {
  const Grid<std::uint8_t> k_map(GridGeometry(1.0, Position::Zero(), 3, 2), kNoCount);
  EXPECT_EQ(test::rowsOf(denseInverseKVisibility(k_map, {0.5, 0.5})), Rows({"???", "???"}));
}

TEST(DenseInverseKVisibility, IsTheInverseInAFlat) {
  const Grid<CellState> plan = flat();
  for (const Position& access_point : {Position(-1.0, 2.1), Position(2.513, 4.021)}) {
    const InverseFigures figures = inverseFigures(plan, access_point);
    EXPECT_GE(figures.found, 0.99) << access_point.transpose();
    EXPECT_LE(figures.falsely, 0.01) << access_point.transpose();
  }
}

}  // namespace
}  // namespace sfw
