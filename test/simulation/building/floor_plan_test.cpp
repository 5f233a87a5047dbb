#include "simulation/building/floor_plan.h"

#include <gtest/gtest.h>

#include "support/ascii_world.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;

/// 'O' outer wall, 'I' interior wall.
Rows rowsOf(const FloorPlan& plan) {
  return test::rowsOf(plan, [](Material material) {
    switch (material) {
      case Material::kFree:
        return '.';
      case Material::kInteriorWall:
        return 'I';
      case Material::kOuterWall:
        return 'O';
      default:
        return '?';
    }
  });
}

Rows materialsOf(const Rows& rows) { return rowsOf(withMaterials(test::world(rows, 0.1))); }

TEST(FloorPlan, StatesForgetTheMaterial) {
  const FloorPlan plan = test::gridFrom<Material>({"?.IO"}, 0.1, [](char c) {
    return c == '.'   ? Material::kFree
           : c == 'I' ? Material::kInteriorWall
           : c == 'O' ? Material::kOuterWall
                      : Material::kUnknown;
  });
  EXPECT_EQ(test::rowsOf(toStates(plan)), (Rows{"?.##"}));
}

TEST(FloorPlan, WallsAtTheOutsideAreOuter) {
  EXPECT_EQ(materialsOf({"???????????????",  //
                         "?#############?",  //
                         "?#.....#.....#?",  //
                         "?#.....#.....#?",  //
                         "?#.....#.....#?",  //
                         "?#.....#.....#?",  //
                         "?#...........#?",  //
                         "?#...........#?",  //
                         "?#############?",  //
                         "???????????????"}),
            (Rows{"???????????????",  //
                  "?OOOOOOOOOOOOO?",  //
                  "?O.....O.....O?",  // where walls meet, a cell may be either
                  "?O.....I.....O?",  //
                  "?O.....I.....O?",  //
                  "?O.....I.....O?",  //
                  "?O...........O?",  //
                  "?O...........O?",  //
                  "?OOOOOOOOOOOOO?",  //
                  "???????????????"}));
}

TEST(FloorPlan, ABuildingMayFillItsGrid) {
  EXPECT_EQ(materialsOf({"##########",  //
                         "#........#",  //
                         "#........#",  //
                         "#........#",  //
                         "#........#",  //
                         "##########"}),
            (Rows{"OOOOOOOOOO",  //
                  "O........O",  //
                  "O........O",  //
                  "O........O",  //
                  "O........O",  //
                  "OOOOOOOOOO"}));
}

TEST(FloorPlan, AShaftIsNotTheOutside) {
  const Rows plan = materialsOf({"#################",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#.....#####.....#",  //
                                 "#.....#???#.....#",  //
                                 "#.....#???#.....#",  //
                                 "#.....#???#.....#",  //
                                 "#.....#####.....#",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#...............#",  //
                                 "#################"});
  EXPECT_EQ(plan[0], "OOOOOOOOOOOOOOOOO");
  EXPECT_EQ(plan[6], "O.....IIIII.....O");
  EXPECT_EQ(plan[8], "O.....I???I.....O");
}

TEST(FloorPlan, SpecksBehindAWallDoNotMakeItInterior) {
  // What a scanner sees through a window.
  const Rows plan = materialsOf({"?????????????",  //
                                 "?????..??????",  //
                                 "?###########?",  //
                                 "?#.........#?",  //
                                 "?#.........#?",  //
                                 "?#.........#?",  //
                                 "?#.........#?",  //
                                 "?#.........#?",  //
                                 "?###########?",  //
                                 "?????????????"});
  EXPECT_EQ(plan[2], "?OOOOOOOOOOO?");
}

TEST(FloorPlan, ThickOuterWallsAreOuterAllThrough) {
  const Rows plan = materialsOf({"#############",  //
                                 "#############",  //
                                 "#############",  //
                                 "###.......###",  //
                                 "###.......###",  //
                                 "###.......###",  //
                                 "###.......###",  //
                                 "###.......###",  //
                                 "#############",  //
                                 "#############",  //
                                 "#############"});
  EXPECT_EQ(plan[5], "OOO.......OOO");
  EXPECT_EQ(plan[2], "OOOOOOOOOOOOO");
}

TEST(FloorPlan, WithoutWallsOrFloorNothingHappens) {
  EXPECT_EQ(materialsOf({"..", ".."}), (Rows{"..", ".."}));
  EXPECT_EQ(materialsOf({"??", "??"}), (Rows{"??", "??"}));
}

}  // namespace
}  // namespace sfw
