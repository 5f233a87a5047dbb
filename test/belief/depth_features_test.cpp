#include <gtest/gtest.h>

#include <cmath>

#include "support/feature_scene.h"

// The features depth_*: how deep a cell lies inside the area that the path encloses, where gaps as
// wide as a disc or a square count as enclosed.

namespace sfw::test {
namespace {

/// '#' in the area, '.' outside, ' ' where cells are farther than 3 m from the path.
Picture areaOf(const std::string& feature, const Picture& path, double resolution_m) {
  return positiveIn(featureOf(FeatureScene{path, resolution_m}, feature));
}

TEST(DepthFeatures, AreMetresToTheEdgeUpToALimit) {
  const FeatureScene scene{Picture(7, "####..."), 0.5};
  for (const char* name : {"depth_disc_0.6", "depth_disc_1.2", "depth_disc_2.4"}) {
    SCOPED_TRACE(name);
    expectEachRow(featureOf(scene, name), {1.2, 1.2, 1.0, 0.5, -0.5, -1.0, -1.2});
  }
}

const Picture kMouthOfOneCell{".......",  //
                              ".#####.",  //
                              ".#...#.",  //
                              ".#.....",  //
                              ".#...#.",  //
                              ".#####.",  //
                              "......."};

TEST(DepthFeatures, ADiscOfOneCellRoundsCorners) {
  EXPECT_EQ(areaOf("depth_disc_0.6", kMouthOfOneCell, 0.6),
            (Picture{".......",  //
                     ".#####.",  //
                     ".##..#.",  //
                     ".#.....",  //
                     ".##..#.",  //
                     ".#####.",  //
                     "......."}));
}

TEST(DepthFeatures, ALargerDiscClosesTheMouth) {
  const Picture closed{".......",  //
                       ".#####.",  //
                       ".#####.",  //
                       ".####..",  //
                       ".#####.",  //
                       ".#####.",  //
                       "......."};
  EXPECT_EQ(areaOf("depth_disc_1.2", kMouthOfOneCell, 0.6), closed);
  EXPECT_EQ(areaOf("depth_disc_2.4", kMouthOfOneCell, 0.6), closed);
}

const Picture kMouthOfThreeCells{"#######",  //
                                 "#.....#",  //
                                 "#......",  //
                                 "#......",  //
                                 "#......",  //
                                 "#.....#",  //
                                 "#######"};

TEST(DepthFeatures, DiscsOfThreeSizesCloseDifferentPartsOfAHall) {
  EXPECT_EQ(areaOf("depth_disc_0.6", kMouthOfThreeCells, 0.6),
            (Picture{"#######",  //
                     "##....#",  //
                     "#......",  //
                     "#......",  //
                     "#......",  //
                     "##....#",  //
                     "#######"}));
  EXPECT_EQ(areaOf("depth_disc_1.2", kMouthOfThreeCells, 0.6),
            (Picture{"#######",  //
                     "###...#",  //
                     "##.....",  //
                     "#......",  //
                     "##.....",  //
                     "###...#",  //
                     "#######"}));
  EXPECT_EQ(areaOf("depth_disc_2.4", kMouthOfThreeCells, 0.6),
            (Picture{"#######",  //
                     "#######",  //
                     "######.",  //
                     "######.",  //
                     "######.",  //
                     "#######",  //
                     "#######"}));
}

const Picture kRing{".......",  //
                    ".#####.",  //
                    ".#...#.",  //
                    ".#...#.",  //
                    ".#...#.",  //
                    ".#####.",  //
                    "......."};

TEST(DepthFeatures, OnlyTheSmallestDiscLeavesAHole) {
  EXPECT_EQ(areaOf("depth_disc_0.6", kRing, 0.6),
            (Picture{".......",  //
                     ".#####.",  //
                     ".##.##.",  //
                     ".#...#.",  //
                     ".##.##.",  //
                     ".#####.",  //
                     "......."}));
  const Picture filled{".......",  //
                       ".#####.",  //
                       ".#####.",  //
                       ".#####.",  //
                       ".#####.",  //
                       ".#####.",  //
                       "......."};
  EXPECT_EQ(areaOf("depth_disc_1.2", kRing, 1.2), filled) << "one cell: as the disc of 0.6 m above";
  EXPECT_EQ(areaOf("depth_disc_1.2", kRing, 0.6), filled);
  EXPECT_EQ(areaOf("depth_disc_2.4", kRing, 0.6), filled);
}

// ---- Squares: the same with straight edges ----

const Picture kNook{".......",  //
                    ".......",  //
                    "..###..",  //
                    "..#....",  //
                    "..###..",  //
                    ".......",  //
                    "......."};

TEST(DepthFeatures, ASquareOfOneCellClosesANookToItsEdge) {
  EXPECT_EQ(areaOf("depth_disc_0.6", kNook, 0.6)[3], "..##...");
  const Picture block{".......",  //
                      ".......",  //
                      "..###..",  //
                      "..###..",  //
                      "..###..",  //
                      ".......",  //
                      "......."};
  EXPECT_EQ(areaOf("depth_square_0.6", kNook, 0.6), block);
}

TEST(DepthFeatures, OfASquareAreMetresToTheEdgeUpToALimit) {
  constexpr double k1 = 0.6;
  const double k2 = 0.6 * std::sqrt(2.0);
  constexpr double k3 = 1.2;
  expectTable(featureOf(FeatureScene{kNook, 0.6}, "depth_square_0.6"),
              {{-k3, -k3, -k3, -k3, -k3, -k3, -k3},
               {-k3, -k2, -k1, -k1, -k1, -k2, -k3},
               {-k3, -k1, k1, k1, k1, -k1, -k3},
               {-k3, -k1, k1, k3, k1, -k1, -k3},
               {-k3, -k1, k1, k1, k1, -k1, -k3},
               {-k3, -k2, -k1, -k1, -k1, -k2, -k3},
               {-k3, -k3, -k3, -k3, -k3, -k3, -k3}});
}

TEST(DepthFeatures, SquaresOfThreeSizesReachByTheirHalfEdges) {
  // A square that reaches two cells touches the nook from everywhere on the grid: all is closed.
  const Picture block{" ..... ",  //
                      ".......",  //
                      "..###..",  //
                      "..###..",  //
                      "..###..",  //
                      ".......",  //
                      " ..... "};
  const Picture all{" ##### ",  //
                    "#######",  //
                    "#######",  //
                    "#######",  //
                    "#######",  //
                    "#######",  //
                    " ##### "};
  EXPECT_EQ(areaOf("depth_square_0.6", kNook, 1.2), block) << "half a cell counts as one";
  EXPECT_EQ(areaOf("depth_square_1.2", kNook, 1.2), block);
  EXPECT_EQ(areaOf("depth_square_2.4", kNook, 1.2), all);
  EXPECT_EQ(areaOf("depth_square_1.2", kNook, 0.6), Picture(7, "#######"));
  const Picture nook{"       ",  //
                     "  ...  ",  //
                     " .###. ",  //
                     " .#..  ",  //
                     " .###. ",  //
                     "  ...  ",  //
                     "       "};
  EXPECT_EQ(areaOf("depth_square_0.6", kNook, 2.4), nook) << "less than half a cell is none";
  EXPECT_EQ(areaOf("depth_square_1.2", kNook, 2.4)[3], " .###  ");
  EXPECT_EQ(areaOf("depth_square_2.4", kNook, 2.4)[3], " .###  ");
}

TEST(DepthFeatures, OnlyTheSmallestSquareLeavesAHole) {
  // The ring lies so near to the grid's edges that the square finds no room between them.
  EXPECT_EQ(areaOf("depth_square_0.6", kRing, 0.6),
            (Picture{"#######",  //
                     "#######",  //
                     "##...##",  //
                     "##...##",  //
                     "##...##",  //
                     "#######",  //
                     "#######"}));
  EXPECT_EQ(areaOf("depth_square_1.2", kRing, 1.2), Picture(7, "#######"));
  EXPECT_EQ(areaOf("depth_square_2.4", kRing, 2.4),
            (Picture{" ##### ",  //
                     "#######",  //
                     "#######",  //
                     "### ###",  //
                     "#######",  //
                     "#######",  //
                     " ##### "}));
}

}  // namespace
}  // namespace sfw::test
