#include <gtest/gtest.h>

#include <cmath>

#include "support/feature_scene.h"

// The features of a cell that depend on where the path lies, each by its name.

namespace sfw::test {
namespace {

const Picture kLeftColumn(7, "#......");

TEST(PathFeatures, DistanceIsThatToThePath) {
  const FeatureScene scene{kLeftColumn, 0.1};
  expectEachRow(featureOf(scene, "path_distance"), {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
}

TEST(PathFeatures, CloseFadesWithinTenCentimetres) {
  const FeatureScene scene{kLeftColumn, 0.1};
  expectEachRow(featureOf(scene, "path_close"),
                {1.0, 0.3679, 0.1353, 0.0498, 0.0183, 0.0067, 0.0025});
}

TEST(PathFeatures, NearFadesWithinFortyCentimetres) {
  const FeatureScene scene{kLeftColumn, 0.1};
  expectEachRow(featureOf(scene, "path_near"),
                {1.0, 0.7788, 0.6065, 0.4724, 0.3679, 0.2865, 0.2231});
}

TEST(PathFeatures, AreOfCellsWithinThreeMetresOnly) {
  const Grid<float> distance = featureOf(FeatureScene{kLeftColumn, 1.0}, "path_distance");
  EXPECT_EQ(positiveIn(distance), Picture(7, ".###   "));
}

// ---- Coverage: the share of cells nearby that the robot's footprint covered ----

const FeatureScene kThreeCells{{".......",  //
                                ".......",  //
                                ".......",  //
                                "...#...",  //
                                "..##...",  //
                                ".......",  //
                                "......."},
                               0.5};

TEST(PathFeatures, SmallCoverageCountsASquareOfThreeCells) {
  constexpr double k1 = 1.0 / 9.0, k2 = 2.0 / 9.0, k3 = 3.0 / 9.0;
  expectTable(featureOf(kThreeCells, "coverage_0.6"), {{0, 0, 0, 0, 0, 0, 0},
                                                       {0, 0, 0, 0, 0, 0, 0},
                                                       {0, 0, k1, k1, k1, 0, 0},
                                                       {0, k1, k3, k3, k2, 0, 0},
                                                       {0, k1, k3, k3, k2, 0, 0},
                                                       {0, k1, k2, k2, k1, 0, 0},
                                                       {0, 0, 0, 0, 0, 0, 0}});
}

TEST(PathFeatures, LargeCoverageCountsASquareOfSevenCells) {
  constexpr double k1 = 1.0 / 49.0, k2 = 2.0 / 49.0, k3 = 3.0 / 49.0;
  expectTable(featureOf(kThreeCells, "coverage_1.5"), {{k1, k1, k1, k1, k1, k1, k1},
                                                       {k3, k3, k3, k3, k3, k3, k2},
                                                       {k3, k3, k3, k3, k3, k3, k2},
                                                       {k3, k3, k3, k3, k3, k3, k2},
                                                       {k3, k3, k3, k3, k3, k3, k2},
                                                       {k3, k3, k3, k3, k3, k3, k2},
                                                       {k3, k3, k3, k3, k3, k3, k2}});
}

TEST(PathFeatures, CoverageIsThatOfTheRobotsFootprint) {
  FeatureScene scene{{".......",  //
                      ".......",  //
                      ".......",  //
                      "...#...",  //
                      "...X...",  //
                      ".......",  //
                      "......."}};
  EXPECT_NEAR(featureAtX(scene, "coverage_0.6"), 1.0 / 9.0, kByHand);
  scene.robot_radius_m = 0.5;  // one cell: a cross of five, of which the square around X holds four
  EXPECT_NEAR(featureAtX(scene, "coverage_0.6"), 4.0 / 9.0, kByHand);
}

// ---- Distances along the building's axes, in shares of 3 m, which are six cells here ----

TEST(PathFeatures, AlongIsTheAxisWithTheNearestFootprint) {
  const FeatureScene scene{{".......",  //
                            "..#....",  // 3 up
                            ".......",  //
                            ".......",  //
                            "#.X...#",  // 2 to the left, 4 to the right
                            "..#....",  // 1 down
                            "......."}};
  EXPECT_NEAR(featureAtX(scene, "nearest_along"), 1.0 / 6.0, kByHand);
  EXPECT_NEAR(featureAtX(scene, "opposite_along"), 3.0 / 6.0, kByHand);
  EXPECT_NEAR(featureAtX(scene, "nearest_across"), 2.0 / 6.0, kByHand);
  EXPECT_NEAR(featureAtX(scene, "opposite_across"), 4.0 / 6.0, kByHand);
}

TEST(PathFeatures, AlongIsOneWhereNoFootprintLies) {
  const FeatureScene scene{{".......",  //
                            ".......",  //
                            ".......",  //
                            "#..X...",  // 3 to the left
                            ".......",  //
                            ".......",  //
                            "......."}};
  EXPECT_NEAR(featureAtX(scene, "nearest_along"), 0.5, kByHand);
  EXPECT_NEAR(featureAtX(scene, "opposite_along"), 1.0, kByHand);
  EXPECT_NEAR(featureAtX(scene, "nearest_across"), 1.0, kByHand);
  EXPECT_NEAR(featureAtX(scene, "opposite_across"), 1.0, kByHand);
}

// ---- The cell of the path from which the cheapest way leads to a cell: its source ----

TEST(PathFeatures, SourceAlignmentIsHowThePathLiesThere) {
  const FeatureScene scene{{"..j....",    //
                            ".i.....",    //
                            "h......",    // a way at 45 degrees to the axes
                            ".......",    //
                            ".......",    //
                            ".......",    //
                            "abcdefg"}};  // and one along an axis
  const Grid<float> alignment = featureOf(scene, "source_alignment");
  for (const float value : alignment.cells) {
    EXPECT_NEAR(std::abs(value), 1.0F, 1e-5F);
  }
  Picture picture = positiveIn(alignment);
  picture[4][0] = '?';  // as far from the one as from the other
  EXPECT_EQ(picture,
            (Picture{".......",  //
                     ".......",  //
                     "......#",  //
                     "....###",  //
                     "?######",  //
                     "#######",  //
                     "#######"}));
}

TEST(PathFeatures, SourceDepthIsThatOfThePathThere) {
  // The source of X lies on its left. What is closed around it is shown in depth_features_test.cpp:
  // with 0.6 m X is not, with 1.2 m X is but not the cell below it, with 2.4 m all are.
  const FeatureScene scene{{"#######",  //
                            "#.....#",  //
                            "#X.....",  //
                            "#......",  //
                            "#......",  //
                            "#.....#",  //
                            "#######"},
                           0.6};
  EXPECT_NEAR(featureAtX(scene, "source_depth_0.6"), 0.6, kByHand);
  EXPECT_NEAR(featureAtX(scene, "source_depth_1.2"), 0.6 * std::sqrt(2.0), kByHand);
  EXPECT_NEAR(featureAtX(scene, "source_depth_2.4"), 1.2, kByHand);
}

}  // namespace
}  // namespace sfw::test
