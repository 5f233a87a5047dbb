#include "simulation/building/wall_crossings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/ascii_world.h"

namespace sfw {
namespace {

/// A plan of 1 m cells.
Grid<CellState> drawn(const std::vector<std::string>& rows) { return test::world(rows, 1.0); }

/// As drawn, with 'O' for outer walls.
FloorPlan drawnPlan(const std::vector<std::string>& rows) {
  return test::gridFrom<Material>(rows, 1.0, [](char c) {
    return c == '.'   ? Material::kFree
           : c == '#' ? Material::kInteriorWall
           : c == 'O' ? Material::kOuterWall
                      : Material::kUnknown;
  });
}

/// Both ways, which must agree.
int countedBothWays(const Grid<CellState>& plan, const Position& a, const Position& b) {
  EXPECT_EQ(countWalls(plan, a, b), countWalls(plan, b, a));
  return countWalls(plan, a, b);
}

TEST(CountWalls, CountsAWallOnceHoweverThick) {
  const Grid<CellState> plan = drawn({".........",  //
                                      ".#.###.##",  //
                                      "........."});
  EXPECT_EQ(countedBothWays(plan, {0.5, 1.5}, {2.5, 1.5}), 1);
  EXPECT_EQ(countedBothWays(plan, {0.5, 1.5}, {6.5, 1.5}), 2);
  EXPECT_EQ(countedBothWays(plan, {0.5, 1.5}, {8.5, 1.5}), 2);
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {8.5, 0.5}), 0);
  EXPECT_EQ(countedBothWays(plan, {2.5, 1.5}, {2.6, 1.4}), 0);
}

TEST(CountWalls, EndsMayLieOutside) {
  const Grid<CellState> plan = drawn({"#..#"});
  EXPECT_EQ(countedBothWays(plan, {-2.0, 0.5}, {6.0, 0.5}), 2);
  EXPECT_EQ(countedBothWays(plan, {-2.0, 0.5}, {1.5, 0.5}), 1);
  EXPECT_EQ(countedBothWays(plan, {-2.0, 0.5}, {-1.0, 9.5}), 0);
}

TEST(CountWalls, AWallThatHoldsAnEndStandsBetweenNothing) {
  const Grid<CellState> plan = drawn({"##.#.##"});
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {2.5, 0.5}), 0);
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {4.5, 0.5}), 1);
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {6.5, 0.5}), 1);
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {1.5, 0.5}), 0);
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {0.5, 0.5}), 0);
}

TEST(CountWalls, UnknownIsNoWall) {
  const Grid<CellState> plan = drawn({"..??.#?#."});
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {4.5, 0.5}), 0);
  EXPECT_EQ(countedBothWays(plan, {0.5, 0.5}, {8.5, 0.5}), 2);
}

TEST(CountWalls, ASlantedWallHasNoGaps) {
  const Grid<CellState> plan = drawn({".....#",  //
                                      "....#.",  //
                                      "...#..",  //
                                      "..#...",  //
                                      ".#....",  //
                                      "#....."});
  EXPECT_EQ(countedBothWays(plan, {1.5, 4.5}, {4.5, 1.5}), 1);  // through a cell
  EXPECT_EQ(countedBothWays(plan, {1.5, 3.5}, {3.5, 1.5}), 1);  // exactly between two cells
  EXPECT_EQ(countedBothWays(plan, {1.5, 2.5}, {2.5, 1.5}), 1);
  EXPECT_EQ(countedBothWays(plan, {1.5, 3.5}, {4.5, 5.5}), 0);
}

/// A wall `thick` cells wide that rises one cell in `run`.
Grid<CellState> rising(std::int64_t thick, std::int64_t run) {
  Grid<CellState> plan(GridGeometry(1.0, Position::Zero(), 60, 90), CellState::kFree);
  for (std::int64_t x = 0; x < 60; ++x) {
    for (std::int64_t y = 0; y < thick; ++y) {
      plan[{x, 20 + x / run + y}] = CellState::kOccupied;
    }
  }
  return plan;
}

TEST(CountWalls, ARisingWallCountsOnceOnLinesThatDoNotRise) {
  for (const std::int64_t thick : {1, 2, 3}) {
    for (const std::int64_t run : {1, 2, 3, 7}) {
      const Grid<CellState> plan = rising(thick, run);
      const Position middle(30.31, 21.17 + 30.0 / static_cast<double>(run));
      for (double down_rad = 0.79; down_rad < 1.57; down_rad += 0.013) {
        const Position half = 15.0 * Position(std::cos(down_rad), -std::sin(down_rad));
        EXPECT_EQ(countedBothWays(plan, middle - half, middle + half), 1)
            << thick << " thick, one in " << run << ", at " << down_rad;
      }
    }
  }
}

TEST(CountWalls, ALineMayLeaveAStaircaseBetweenItsSteps) {
  const Grid<CellState> plan = drawn({".....#",  //
                                      "....#.",  //
                                      "...#..",  //
                                      "..#...",  //
                                      ".#....",  //
                                      "#....."});
  EXPECT_EQ(countedBothWays(plan, {0.5, 2.05}, {5.5, 4.05}), 2);
}

TEST(CountWalls, IsSymmetricInARandomWorld) {
  Grid<CellState> plan(GridGeometry(0.5, {-3.0, 2.0}, 40, 30), CellState::kFree);
  std::uint32_t state = 1;
  const auto random = [&state] {
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state >> 8) / static_cast<double>(1U << 24);
  };
  for (CellState& cell : plan.cells) {
    cell = random() < 0.3 ? CellState::kOccupied : CellState::kFree;
  }
  for (int i = 0; i < 2000; ++i) {
    const Position a(-4.0 + 22.0 * random(), 1.0 + 17.0 * random());
    const Position b(-4.0 + 22.0 * random(), 1.0 + 17.0 * random());
    countedBothWays(plan, a, b);
  }
}

// ---- wallsBetween ----

TEST(WallsBetween, TellsPlaceAndMaterialInOrder) {
  const FloorPlan plan = drawnPlan({".##..O.#."});
  const std::vector<WallCrossing> walls = wallsBetween(plan, {0.5, 0.5}, {8.5, 0.5});
  ASSERT_EQ(walls.size(), 3U);
  EXPECT_EQ(walls[0].middle, Position(2.0, 0.5));
  EXPECT_EQ(walls[0].material, Material::kInteriorWall);
  EXPECT_EQ(walls[1].middle, Position(5.5, 0.5));
  EXPECT_EQ(walls[1].material, Material::kOuterWall);
  EXPECT_EQ(walls[2].middle, Position(7.5, 0.5));
  EXPECT_EQ(wallsBetween(plan, {8.5, 0.5}, {0.5, 0.5})[0].middle, Position(7.5, 0.5));
}

TEST(WallsBetween, AWallIsOfWhatMostOfItsCellsAreMadeOf) {
  EXPECT_EQ(wallsBetween(drawnPlan({".O##."}), {0.5, 0.5}, {4.5, 0.5})[0].material,
            Material::kInteriorWall);
  EXPECT_EQ(wallsBetween(drawnPlan({".OO#."}), {0.5, 0.5}, {4.5, 0.5})[0].material,
            Material::kOuterWall);
}

TEST(WallsBetween, CountsAsForStates) {
  const FloorPlan plan = drawnPlan({".O.?.#.", "..O..#."});
  EXPECT_EQ(countWalls(plan, {0.5, 1.5}, {6.5, 1.5}), 2);
  EXPECT_EQ(countWalls(plan, {0.5, 1.5}, {6.5, 0.5}),
            countWalls(toStates(plan), {0.5, 1.5}, {6.5, 0.5}));
}

}  // namespace
}  // namespace sfw
