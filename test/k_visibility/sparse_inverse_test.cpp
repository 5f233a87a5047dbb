#include "k_visibility/sparse_inverse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/radio_scene.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;
using test::coarseSettings;
using test::countedIn;
using test::inferred;
using test::rowsOf;

// ---- The four rules ----

TEST(RuleOne, FreesThePathWithTheRobotsFootprint) {
  SparseInverseConfig settings = coarseSettings();
  settings.footprint_radius_m = 1.5;
  settings.max_gap_m = 5.0;
  const std::atomic<bool> never{false};
  const GridGeometry geometry(1.0, {0, 0}, 10, 7);
  const std::vector<Position> path{{2.5, 3.5}, {7.5, 3.5}};
  EXPECT_EQ(rowsOf(inferOccupancy(geometry, {}, path, {}, settings, never)),
            (Rows{"??????????",  //
                  "??????????",  //
                  "?........?",  //
                  "?........?",  //
                  "?........?",  //
                  "??????????",  //
                  "??????????"}));
}

TEST(RuleOne, LeavesOutGapsOfThePath) {
  SparseInverseConfig settings = coarseSettings();
  settings.max_gap_m = 2.0;
  const std::atomic<bool> never{false};
  const std::vector<Position> path{{0.5, 0.5}, {2.5, 0.5}, {6.5, 0.5}, {7.5, 0.5}};
  EXPECT_EQ(rowsOf(inferOccupancy(GridGeometry(1.0, {0, 0}, 9, 1), {}, path, {}, settings, never)),
            (Rows{"...???..?"}));
}

TEST(RuleOne, FreesTheRobotsCellHoweverSmallTheRobot) {
  SparseInverseConfig settings = coarseSettings();
  settings.footprint_radius_m = 0.0;
  settings.max_gap_m = 9.0;
  const std::atomic<bool> never{false};
  const std::vector<Position> path{{0.1, 0.1}, {4.9, 0.1}};
  EXPECT_EQ(rowsOf(inferOccupancy(GridGeometry(1.0, {0, 0}, 6, 1), {}, path, {}, settings, never)),
            (Rows{".....?"}));
}

TEST(RuleOne, KeepsContactCellsUnderTheFootprint) {
  SparseInverseConfig settings = coarseSettings();
  settings.footprint_radius_m = 1.5;
  const Rows scene{"?????",  //
                   "?????",  //
                   "??0??",  //
                   "?????",  //
                   "?????"};
  const std::vector<Contact> contacts{{0, {3.2, 2.9}}, {0, {0.5, 4.5}}, {0, {99.0, -1.0}}};
  EXPECT_EQ(rowsOf(inferred(scene, settings, contacts)), (Rows{"#????",  //
                                                               "?...?",  //
                                                               "?..#?",  //
                                                               "?...?",  //
                                                               "?????"}));
}

TEST(RuleTwo, FreesTheRayOfAPoseThatNoWallHides) {
  EXPECT_EQ(rowsOf(inferred(Rows{"?????????",  //
                                 "?R?????0?",  //
                                 "?????????"})),
            (Rows{"?????????",  //
                  "??......?",  //
                  "?????????"}));
  EXPECT_EQ(rowsOf(inferred(Rows{"????0",  //
                                 "?????",  //
                                 "?????",  //
                                 "?????",  //
                                 "R????"})),
            (Rows{"????.",  //
                  "???.?",  //
                  "??.??",  //
                  "?.???",  //
                  "?????"}));
}

TEST(RuleThree, NeverFreesARayThatCrossesWalls) {
  for (const int walls : {1, 2, 3}) {
    for (std::size_t cells = 1; cells < 60; ++cells) {
      const Rows scene{"R" + std::string(cells, '?') + std::to_string(walls)};
      const Grid<float> map = inferred(scene);
      for (std::size_t i = 0; i < cells; ++i) {
        ASSERT_GE(map.cells[1 + i], 0.5F - 1e-6F) << walls << " walls on " << cells << " cells";
      }
    }
  }
}

TEST(RuleFour, FreesWhatLiesBetweenEqualCountsOnARay) {
  EXPECT_EQ(rowsOf(inferred(Rows{"R???1????1"})), (Rows{"??#?......"}));
  EXPECT_EQ(rowsOf(inferred(Rows{"R????2???2"})), (Rows{"?####....."}));
}

// ---- Segments ----

TEST(Segments, DrawOneWallInTheMiddle) {
  EXPECT_EQ(rowsOf(inferred(Rows{"R???1"})), (Rows{"??#?."}));
  EXPECT_EQ(rowsOf(inferred(Rows{"R?????1"})), (Rows{"???#??."}));
}

TEST(Segments, DrawTwoWallsEvenlyPlaced) {
  EXPECT_EQ(rowsOf(inferred(Rows{"R??????2"})), (Rows{"??#??#?."}));
  EXPECT_EQ(rowsOf(inferred(Rows{"R?0??????2"})), (Rows{"?..?#??#?."}));
}

TEST(Segments, SayNothingWhenTheirCountsContradict) {
  EXPECT_EQ(rowsOf(inferred(Rows{"R???1???0"})), (Rows{"??#?.???."}));
}

TEST(Segments, FindNoRoomForAWallBetweenTwoFootprints) {
  // A footprint of 0.4 m on either side and a wall of 1 m take 1.8 m.
  EXPECT_EQ(rowsOf(inferred(Rows{"R?0?1"})), (Rows{"?..?."}));
  EXPECT_EQ(rowsOf(inferred(Rows{"R?0??1"})), (Rows{"?..##."}));
}

TEST(Segments, TakeTheCountsOfThePosesOnTheWay) {
  EXPECT_EQ(rowsOf(inferred(Rows{"??????????",  //
                                 "R???0???1?",  //
                                 "??????????"})),
            (Rows{"??????????",  //
                  "?....?#?.?",  //
                  "??????????"}));
}

// ---- Fusion ----

double logit(double p) { return std::log(p / (1.0 - p)); }

TEST(Fusion, WeighsRaysByTheInverseOfTheirVariance) {
  // Two access points cross in the middle cell: one sees a wall on 3 cells, the other none on 5.
  const CountedPath wall = countedIn({"???????",  //
                                      "???????",  //
                                      "???????",  //
                                      "?R???1?",  //
                                      "???????",  //
                                      "???????",  //
                                      "???????"});
  const CountedPath open = countedIn({"???0???",  //
                                      "???????",  //
                                      "???????",  //
                                      "???????",  //
                                      "???????",  //
                                      "???????",  //
                                      "???R???"});
  const Grid<float> map = inferred(GridGeometry(1.0, {0, 0}, 7, 7), {wall, open});
  // By hand: a bell of deviation 3/4 on three cells has 1 / (1 + 2 exp(-8/9)) of its mass in the
  // middle; mass 0 joins it with weights 1/9 and 1/25.
  const double middle = 1.0 / (1.0 + 2.0 * std::exp(-8.0 / 9.0));
  const double mass = (middle / 9.0) / (1.0 / 9.0 + 1.0 / 25.0);
  const double expected = 1.0 / (1.0 + std::exp(logit(0.2) - logit(mass)));
  EXPECT_NEAR((map[{3, 3}]), expected, 1e-6);
  // Cells that one ray alone sees.
  EXPECT_NEAR((map[{2, 3}]),
              1.0 / (1.0 + std::exp(logit(0.2) - logit(middle * std::exp(-8.0 / 9.0)))), 1e-6);
  EXPECT_NEAR((map[{3, 2}]), 0.05, 1e-6);
}

TEST(Fusion, DoesNotGrowSurerByRepeatingARay) {
  const CountedPath once = countedIn({"R???1"});
  CountedPath often = once;
  for (int i = 0; i < 1000; ++i) {
    often.poses.push_back(once.poses.front());
  }
  const GridGeometry geometry(1.0, {0, 0}, 5, 1);
  EXPECT_EQ(inferred(geometry, {once}).cells, inferred(geometry, {often}).cells);
}

TEST(Fusion, JoinsTwoAccessPoints) {
  const CountedPath left = countedIn({"R?????1"});
  const CountedPath right = countedIn({"????0?R"});
  const GridGeometry geometry(1.0, {0, 0}, 7, 1);
  EXPECT_EQ(rowsOf(inferred(geometry, {left})), (Rows{"???#??."}));
  EXPECT_EQ(rowsOf(inferred(geometry, {right})), (Rows{"????..?"}));
  EXPECT_EQ(rowsOf(inferred(geometry, {left, right})), (Rows{"???#..."}));
}

TEST(Fusion, DoesNotDependOnTheOrderOfAccessPoints) {
  const std::vector<CountedPath> counted{countedIn({"R??0??1", "???????", "??0????"}),
                                         countedIn({"???0??1", "R??????", "??0????"}),
                                         countedIn({"???2??1", "???????", "??0???R"})};
  const GridGeometry geometry(1.0, {0, 0}, 7, 3);
  const Grid<float> forward = inferred(geometry, counted);
  const Grid<float> backward = inferred(geometry, {counted[2], counted[1], counted[0]});
  for (std::size_t i = 0; i < forward.cells.size(); ++i) {
    EXPECT_NEAR(forward.cells[i], backward.cells[i], 1e-6);  // the last bits of a sum may differ
  }
}

TEST(Fusion, KeepsFreeSpaceFreeForAnyWallDensity) {
  for (const double density : {1e-12, 1e-6, 0.02, 0.5, 0.99, 1.0 - 1e-12}) {
    SparseInverseConfig settings = coarseSettings();
    settings.wall_prior = density;
    EXPECT_EQ(rowsOf(inferred(Rows{"R???0"}, settings)), (Rows{"?...."})) << density;
  }
}

// ---- Places ----

TEST(Places, OutsideTheGridAreLeftOut) {
  CountedPath counted = countedIn({"R???0?"});
  const GridGeometry geometry(1.0, {0, 0}, 6, 1);
  const Grid<float> map = inferred(geometry, {counted});
  for (const Position& outside :
       {Position(-3.5, 0.5), Position(2.5, 77.0), Position(6.0, 0.5), Position(1e6, -1e6)}) {
    counted.poses.push_back({outside, 3});
  }
  EXPECT_EQ(inferred(geometry, {counted}).cells, map.cells);
}

TEST(Places, OutsideTheGridMayHoldTheAccessPoint) {
  CountedPath counted = countedIn({"???????",  //
                                   "?????0?",  //
                                   "???????"});
  counted.access_point = {-20.5, 1.5};
  const GridGeometry geometry(1.0, {0, 0}, 7, 3);
  EXPECT_EQ(rowsOf(inferred(geometry, {counted})), (Rows{"???????",  //
                                                         "......?",  //
                                                         "???????"}));
}

TEST(Places, UnderTheAccessPointSayNothingButTheirFootprint) {
  for (const int walls : {0, 1}) {
    const CountedPath counted{{1.5, 1.5}, {{{1.5, 1.5}, walls}, {{1.25, 1.75}, walls}}};
    EXPECT_EQ(rowsOf(inferred(GridGeometry(1.0, {0, 0}, 3, 3), {counted})), (Rows{"???",  //
                                                                                  "?.?",  //
                                                                                  "???"}));
  }
}

TEST(Places, ThatNoRaySeesAreExactlyUndecided) {
  const Grid<float> map = inferred(Rows{"????",  //
                                        "R??0"});
  EXPECT_EQ((map[{0, 1}]), 0.5F);
  EXPECT_EQ((map[{3, 1}]), 0.5F);
}

TEST(Inference, ReturnsEarlyWhenToldToStop) {
  const std::atomic<bool> stop{true};
  const CountedPath counted = countedIn({"R???0"});
  const Grid<float> map = inferOccupancy(GridGeometry(1.0, {0, 0}, 5, 1), {counted},
                                         test::pathOf({counted}), {}, coarseSettings(), stop);
  EXPECT_EQ(rowsOf(map), (Rows{"????."}));
}

}  // namespace
}  // namespace sfw
