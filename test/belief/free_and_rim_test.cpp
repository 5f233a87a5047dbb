#include "belief/free_and_rim.h"

#include <gtest/gtest.h>

#include "support/ascii_world.h"
#include "support/number_table.h"

namespace sfw::test {
namespace {

using Rows = std::vector<std::string>;

/// Probabilities: '.' nearly free, 'o' a little over the threshold of free cells, 'w' doubtful,
/// '#' likely occupied, 'C' a contact, '?' no evidence.
float probability(char c) {
  switch (c) {
    case '.':
      return 0.05F;
    case 'o':
      return 0.25F;
    case 'w':
      return 0.4F;
    case '#':
      return 0.8F;
    case 'C':
      return 0.95F;
    default:
      return 0.5F;
  }
}

Grid<float> probabilities(const Rows& rows) { return gridFrom<float>(rows, 1.0, probability); }

Config::Belief occupiedRim() {
  Config::Belief config;
  config.rim = "occupied";
  return config;
}

/// The map of some probabilities: '.' free, '#' occupied, '?' unknown.
/// @param walls  as '#'; empty: none
Rows labelled(const Rows& rows, const Cell& path_cell, const Rows& walls = {},
              const Config::Belief& config = occupiedRim()) {
  Grid<float> occupied = probabilities(rows);
  Mask path(occupied.geometry);
  path[path_cell] = 1;
  labelFreeAndRim(path, walls.empty() ? Mask(occupied.geometry) : mask(walls), config, occupied);
  return rowsOf(occupied, [&](float p) {
    return static_cast<double>(p) < config.free_threshold       ? '.'
           : static_cast<double>(p) > config.occupied_threshold ? '#'
                                                                : '?';
  });
}

TEST(FreeAndRim, OccupiesTheRimAndNothingBeyond) {
  EXPECT_EQ(labelled({"#######",  //
                      "wwwwwww",  //
                      "ww...ww",  //
                      "##...##",  //
                      "ww...ww",  //
                      "wwwwwww",  //
                      "......."},
                     {3, 3}),
            (Rows{"???????",  //
                  "?#####?",  //
                  "?#...#?",  //
                  "?#...#?",  //
                  "?#...#?",  //
                  "?#####?",  //
                  "???????"}));
}

TEST(FreeAndRim, FreesOnlyTheRoomOfThePath) {
  const Rows rooms{"...w...",  //
                   "...w...",  //
                   "...w...",  //
                   "...w...",  //
                   "wwww...",  //
                   ".......",  //
                   "......."};
  EXPECT_EQ(labelled(rooms, {0, 6}), (Rows{"...#???",  //
                                           "...#???",  //
                                           "...#???",  //
                                           "...#???",  //
                                           "####???",  //
                                           "???????",  //
                                           "???????"}));
  EXPECT_EQ(labelled(rooms, {6, 6}),
            (Rows{"???#...",  //
                  "???#...",  //
                  "???#...",  //
                  "???#...",  //
                  "####...",  //
                  ".......",  //
                  "......."}));
}

TEST(FreeAndRim, ConnectsOverEdgesNotOverCorners) {
  EXPECT_EQ(labelled({"...wwww",  //
                      "...wwww",  //
                      "...wwww",  //
                      "www...w",  //
                      "www...w",  //
                      "www...w",  //
                      "wwwwwww"},
                     {0, 6}),
            (Rows{"...#???",  //
                  "...#???",  //
                  "...#???",  //
                  "####???",  //
                  "???????",  //
                  "???????",  //
                  "???????"}));
}

TEST(FreeAndRim, FreesIslandsOfLittleDoubt) {
  EXPECT_EQ(labelled({".......",   //
                      ".oo....",   //
                      ".......",   //
                      "....oo.",   //
                      "....ow.",   // one doubtful cell keeps an island
                      ".......",   //
                      "o......"},  // at the edge of the grid nobody knows how it goes on
                     {3, 6}),
            (Rows{".......",  //
                  ".......",  //
                  ".......",  //
                  "....##.",  //
                  "....##.",  //
                  ".......",  //
                  "#......"}));
}

TEST(FreeAndRim, KeepsContactsAndCellsWithoutEvidence) {
  EXPECT_EQ(labelled({".......",  //
                      ".C.....",  //
                      ".......",  //
                      "....?..",  //
                      ".......",  //
                      ".......",  //
                      "???????"},
                     {3, 6}),
            (Rows{".......",  //
                  ".#.....",  //
                  ".......",  //
                  "....?..",  //
                  ".......",  //
                  ".......",  //
                  "???????"}));
}

TEST(FreeAndRim, WallsAreOccupiedAndCloseTheWay) {
  EXPECT_EQ(labelled({".......",  //
                      ".......",  //
                      "......."},
                     {0, 1},
                     {"...#...",  //
                      "...#...",  //
                      "...#..."}),
            (Rows{"...#???",  //
                  "...#???",  //
                  "...#???"}));
}

TEST(FreeAndRim, TheRimMayStayUnknown) {
  Config::Belief config;
  config.rim = "unknown";
  EXPECT_EQ(labelled({"wwwwwww",  //
                      "w.....w",  //
                      "w.....w",  //
                      "wwwwwww"},
                     {1, 1},
                     {".......",  //
                      ".....#.",  //
                      ".....#.",  //
                      "......."},
                     config),
            (Rows{"???????",  //
                  "?....#?",  //
                  "?....#?",  //
                  "???????"}));
}

TEST(FreeAndRim, KeepsProbabilitiesAwayFromTheThresholds) {
  // Free below 0.2, occupied above 0.65.
  Grid<float> occupied(GridGeometry(1.0, {0.0, 0.0}, 7, 1));
  occupied.cells = {0.01F, 0.199F, 0.21F, 0.9F, 0.21F, 0.64F, 0.4F};
  Mask path(occupied.geometry);
  path.cells[0] = 1;
  labelFreeAndRim(path, Mask(occupied.geometry), occupiedRim(), occupied);
  expectTable(occupied, {{0.01, 0.185, 0.67, 0.63, 0.22, 0.63, 0.4}});
}

TEST(FreeAndRim, KeepsALikelyRimAsItIs) {
  Grid<float> occupied(GridGeometry(1.0, {0.0, 0.0}, 3, 1));
  occupied.cells = {0.01F, 0.9F, 0.4F};
  Mask path(occupied.geometry);
  path.cells[0] = 1;
  labelFreeAndRim(path, Mask(occupied.geometry), occupiedRim(), occupied);
  expectTable(occupied, {{0.01, 0.9, 0.4}});
}

// ---- The robot's body ----

TEST(Footprint, IsFreeAroundThePath) {
  Grid<float> occupied = probabilities(Rows(7, "#######"));
  Mask path(occupied.geometry);
  path[{1, 3}] = path[{2, 3}] = 1;
  occupied[{2, 3}] = 0.01F;  // surer still
  stampFootprintAndContacts(path, {}, 1.0, occupied);
  constexpr double kWall = 0.8, kFree = 0.02;
  expectTable(occupied, {{kWall, kWall, kWall, kWall, kWall, kWall, kWall},
                         {kWall, kWall, kWall, kWall, kWall, kWall, kWall},
                         {kWall, kFree, kFree, kWall, kWall, kWall, kWall},
                         {kFree, kFree, 0.01, kFree, kWall, kWall, kWall},
                         {kWall, kFree, kFree, kWall, kWall, kWall, kWall},
                         {kWall, kWall, kWall, kWall, kWall, kWall, kWall},
                         {kWall, kWall, kWall, kWall, kWall, kWall, kWall}});
}

TEST(Footprint, YieldsToAContact) {
  Grid<float> occupied(GridGeometry(1.0, {0.0, 0.0}, 3, 1), 0.5F);
  Mask path(occupied.geometry);
  path.cells[0] = 1;
  stampFootprintAndContacts(path, {{0, {0.5, 0.5}}, {0, {2.5, 0.5}}, {0, {9.5, 0.5}}}, 1.0,
                            occupied);
  expectTable(occupied, {{0.95, 0.02, 0.95}});
}

}  // namespace
}  // namespace sfw::test
