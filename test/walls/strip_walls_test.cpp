#include "walls/strip_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/ascii_world.h"

namespace sfw::test {
namespace {

using Rows = std::vector<std::string>;

/// Two passes of the robot ('o') with a strip between them. A digit is a density in tenths.
const Rows kStrip{"o.2421.o",  //
                  "o.2421.o",  //
                  "o.2421.o",  //
                  "o.2421.o",  //
                  "o.2421.o",  //
                  "o.2421.o",  //
                  "o.2421.o"};

StripWallConfig config() {
  StripWallConfig config;
  config.least_expected = 0.7;
  return config;
}

struct Scene {
  Mask footprint;
  Grid<float> density;
  Mask free;
};

Scene sceneOf(const Rows& rows) {
  constexpr double kResolution = 0.1;
  const auto mask = [](char c) { return static_cast<std::uint8_t>(c == 'o' ? 1 : 0); };
  const auto free = [](char c) { return static_cast<std::uint8_t>(c == '#' ? 0 : 1); };
  const auto density = [](char c) {
    return c >= '0' && c <= '9' ? 0.1F * static_cast<float>(c - '0') : 0.0F;
  };
  return {gridFrom<std::uint8_t>(rows, kResolution, mask),
          gridFrom<float>(rows, kResolution, density),
          gridFrom<std::uint8_t>(rows, kResolution, free)};
}

/// The walls as '#', all else as '.'.
Rows drawn(const Scene& scene, const StripWallConfig& settings) {
  Mask walls(scene.footprint.geometry);
  for (const StripWall& wall :
       findStripWalls(scene.footprint, scene.density, scene.free, settings).walls) {
    for (const Cell c : wall.cells) {
      walls[c] = 1;
    }
  }
  return rowsOf(walls, [](std::uint8_t wall) { return wall != 0 ? '#' : '.'; });
}

Rows wallsIn(const Rows& rows, const StripWallConfig& settings = config()) {
  return drawn(sceneOf(rows), settings);
}

Rows transposed(const Rows& rows) {
  Rows result(rows.front().size(), std::string(rows.size(), ' '));
  for (std::size_t y = 0; y < rows.size(); ++y) {
    for (std::size_t x = 0; x < rows[y].size(); ++x) {
      result[x][y] = rows[y][x];
    }
  }
  return result;
}

TEST(StripWalls, DrawsOneWallAtTheLikeliestPlaceOfAStrip) {
  // No cell has more than 0.4 expected walls, but all across have 0.9.
  EXPECT_EQ(wallsIn(kStrip), Rows(7, "...#...."));
}

TEST(StripWalls, TurnsWithTheWorld) {
  EXPECT_EQ(wallsIn(transposed(kStrip)), transposed(Rows(7, "...#....")));
}

TEST(StripWalls, DrawsNothingBelowTheLimit) {
  StripWallConfig settings = config();
  settings.least_expected = 1.0;
  EXPECT_EQ(wallsIn(kStrip, settings), Rows(7, "........"));
}

TEST(StripWalls, ReportsTheExpectedNumberOfWalls) {
  const Scene scene = sceneOf(kStrip);
  const std::vector<StripWall> walls =
      findStripWalls(scene.footprint, scene.density, scene.free, config()).walls;
  ASSERT_EQ(walls.size(), 1U);
  EXPECT_NEAR(walls.front().expected, 0.9, 1e-5);
}

TEST(StripWalls, LeavesOutShortWallsAndWideStrips) {
  StripWallConfig settings = config();
  settings.shortest_m = 0.8;
  EXPECT_EQ(wallsIn(kStrip, settings), Rows(7, "........"));
  settings = config();
  settings.widest_m = 0.5;
  EXPECT_EQ(wallsIn(kStrip, settings), Rows(7, "........"));
}

TEST(StripWalls, AnEndGrowsToTheNextBarrier) {
  Rows rows = kStrip;
  rows.insert(rows.end(), {"........", "........", "########"});
  Rows expected(9, "...#....");
  expected.emplace_back("........");
  EXPECT_EQ(wallsIn(rows), expected);
}

TEST(StripWalls, ADoorStaysOpenWhereTheRobotWentThrough) {
  Rows rows = kStrip;
  rows.insert(rows.end(), {"oooooooo", "........", "########"});
  const Rows walls = wallsIn(rows);
  for (std::size_t y = 7; y < 10; ++y) {
    EXPECT_EQ(walls[y], "........") << y;
  }
}

// ---- Walls beyond the outermost passes ----

/// One pass; free cells to its right ('.'), then cells that are not believed to be free.
const Rows kOuter{"o..#242#",  //
                  "o..#242#",  //
                  "o..#242#",  //
                  "o..#242#",  //
                  "o..#242#"};

/// As sceneOf, but cells with a density are not believed to be free.
Rows outerWallsIn(const Rows& rows, const StripWallConfig& settings = config()) {
  Scene scene = sceneOf(rows);
  for (std::size_t i = 0; i < scene.free.cells.size(); ++i) {
    scene.free.cells[i] = scene.density.cells[i] > 0.0F ? 0 : scene.free.cells[i];
  }
  return drawn(scene, settings);
}

TEST(OuterWalls, StandAtTheLikeliestPlaceBeyondTheLastPass) {
  EXPECT_EQ(outerWallsIn(kOuter), Rows(5, ".....#.."));
  EXPECT_EQ(outerWallsIn(transposed(kOuter)), transposed(Rows(5, ".....#..")));
}

TEST(OuterWalls, AreNotSearchedFarFromThePass) {
  StripWallConfig settings = config();
  settings.beyond_m = 0.5;  // the first two cells with a density have 0.6 expected walls
  EXPECT_EQ(outerWallsIn(kOuter, settings), Rows(5, "........"));
}

TEST(OuterWalls, LeaveFreeCellsFree) {
  // All cells are believed to be free.
  EXPECT_EQ(wallsIn(Rows(7, "o.2421..")), Rows(7, "........"));
}

TEST(OuterWalls, StandOnBothSidesOfAGapThatIsTooWideForAStrip) {
  StripWallConfig settings = config();
  settings.widest_m = 0.6;
  settings.beyond_m = 0.3;
  EXPECT_EQ(outerWallsIn(Rows(5, "o.8.....8.o"), settings), Rows(5, "..#.....#.."));
}

// ---- Strips without a wall ----

Rows openIn(const Rows& rows) {
  const Scene scene = sceneOf(rows);
  return rowsOf(findStripWalls(scene.footprint, scene.density, scene.free, config()).open,
                [](std::uint8_t open) { return open != 0 ? '+' : '.'; });
}

TEST(OpenStrips, HaveFewExpectedWalls) {
  EXPECT_EQ(openIn(Rows(5, "o.12..o")), Rows(5, ".+++++."));  // 0.3 expected walls
  EXPECT_EQ(openIn(Rows(5, "o.22..o")), Rows(5, "......."));  // 0.4: neither open nor closed
}

TEST(OpenStrips, LieBetweenTwoPasses) { EXPECT_EQ(openIn(Rows(5, "o.1....")), Rows(5, ".......")); }

TEST(OpenStrips, AreNotClosedAlongTheOtherAxis) {
  // The columns are open; each row has 0.9 expected walls.
  Rows rows = {"oooooooo"};
  rows.insert(rows.end(), kStrip.begin(), kStrip.begin() + 5);
  rows.emplace_back("oooooooo");
  for (const std::string& row : openIn(rows)) {
    EXPECT_EQ(row, "........");
  }
}

}  // namespace
}  // namespace sfw::test
