#include <gtest/gtest.h>

#include <cmath>

#include "radio/path_loss.h"
#include "support/feature_scene.h"

// The features of a cell that depend on access points, rays, and the walls that tomography found,
// each by its name.

namespace sfw::test {
namespace {

// ---- Rays: where signals passed ----

/// An access point on the left with a bin in the middle and one on the right, and another one at
/// the bottom with a bin at the top. Rays lose 2, 8 and 4 dB.
FeatureScene threeRays() {
  FeatureScene scene{{".......",  //
                      ".......",  //
                      ".......",  //
                      "...#...",  //
                      ".......",  //
                      ".......",  //
                      "......."}};
  scene.access_points = {accessPointAt(scene, {0, 3}, {{3, 3}, {6, 3}}),
                         accessPointAt(scene, {3, 0}, {{3, 6}})};
  scene.ray_loss_db = {{2.0, 8.0}, {4.0}};
  return scene;
}

/// A table of values on the row and on the column in the middle, 0 elsewhere.
Table cross(double column, const std::vector<double>& row) {
  Table table(7, {0.0, 0.0, 0.0, column, 0.0, 0.0, 0.0});
  table[3] = row;
  return table;
}

TEST(RadioFeatures, RaysIsALogarithmOfTheirNumber) {
  // log2(1 + n) / 6 for one, two and three rays.
  constexpr double k1 = 0.1667, k2 = 0.2642, k3 = 0.3333;
  expectTable(featureOf(threeRays(), "rays"), cross(k1, {k2, k2, k2, k3, k1, k1, k1}));
}

TEST(RadioFeatures, RaysIsOneFromSixtyThreeOnwards) {
  FeatureScene scene{{"X#....."}};
  scene.access_points = {accessPointAt(scene, {0, 0}, std::vector<Cell>(62, {6, 0}))};
  scene.ray_loss_db = {std::vector<double>(62, 0.0)};
  EXPECT_NEAR(featureAtX(scene, "rays"), std::log2(63.0) / 6.0, 1e-6);
  scene.access_points = {accessPointAt(scene, {0, 0}, std::vector<Cell>(100, {6, 0}))};
  scene.ray_loss_db = {std::vector<double>(100, 0.0)};
  EXPECT_EQ(featureAtX(scene, "rays"), 1.0);
}

TEST(RadioFeatures, AccessPointsIsTheShareWithARayHere) {
  expectTable(featureOf(threeRays(), "access_points"),
              cross(0.5, {0.5, 0.5, 0.5, 1.0, 0.5, 0.5, 0.5}));
}

TEST(RadioFeatures, LineOfSightFadesWithTheLeastLoss) {
  // exp(-loss / 4 dB) for 2, 4 and 8 dB.
  constexpr double k2 = 0.6065, k4 = 0.3679, k8 = 0.1353;
  expectTable(featureOf(threeRays(), "line_of_sight"), cross(k4, {k2, k2, k2, k2, k8, k8, k8}));
}

TEST(RadioFeatures, LineOfSightOverALimitIsTheExcess) {
  expectTable(featureOf(threeRays(), "line_of_sight_over_0.1"),
              cross(0.2679, {0.5065, 0.5065, 0.5065, 0.5065, 0.0353, 0.0353, 0.0353}));
  expectTable(featureOf(threeRays(), "line_of_sight_over_0.4"),
              cross(0.0, {0.2065, 0.2065, 0.2065, 0.2065, 0.0, 0.0, 0.0}));
}

TEST(RadioFeatures, AccessPointNearFadesWithinAMetreAndEndsAtThree) {
  FeatureScene scene{{"######X"}};
  scene.access_points = {accessPointAt(scene, {0, 0}, {})};
  scene.ray_loss_db = {{}};
  expectTable(featureOf(scene, "access_point_near"),
              {{1.0, 0.6065, 0.3679, 0.2231, 0.1353, 0.0821, 0.0498}});
  scene.access_points.front().position.y() += 5.0;
  EXPECT_NEAR(featureAtX(scene, "access_point_near"), std::exp(-3.0), kByHand);
  scene.access_points.push_back(accessPointAt(scene, {5, 0}, {}));
  scene.ray_loss_db.emplace_back();
  EXPECT_NEAR(featureAtX(scene, "access_point_near"), 0.6065, kByHand) << "the nearest counts";
  scene.access_points.clear();
  scene.ray_loss_db.clear();
  EXPECT_NEAR(featureAtX(scene, "access_point_near"), std::exp(-3.0), kByHand);
}

// ---- Walls that tomography found ----

/// Cells of 0.2 m, a wall of 3 dB in the middle and one of 6 dB at the lower right.
const FeatureScene kTwoWalls{{"#......",  //
                              ".......",  //
                              ".......",  //
                              ".......",  //
                              ".......",  //
                              ".......",  //
                              "......."},
                             0.2,
                             {".......",  //
                              ".......",  //
                              ".......",  //
                              "...3...",  //
                              ".......",  //
                              ".......",  //
                              "......6"}};

TEST(RadioFeatures, WallStrengthSaturatesWithinDecibels) {
  // 1 - exp(-strength / 1.5 dB) for 3 and 6 dB.
  constexpr double k3 = 0.8647, k6 = 0.9817;
  expectTable(featureOf(kTwoWalls, "wall_strength"), {{0, 0, 0, 0, 0, 0, 0},
                                                      {0, 0, 0, 0, 0, 0, 0},
                                                      {0, 0, 0, 0, 0, 0, 0},
                                                      {0, 0, 0, k3, 0, 0, 0},
                                                      {0, 0, 0, 0, 0, 0, 0},
                                                      {0, 0, 0, 0, 0, 0, 0},
                                                      {0, 0, 0, 0, 0, 0, k6}});
  const Grid<float> over = featureOf(kTwoWalls, "wall_strength_over_0.1");
  EXPECT_NEAR((over[Cell{3, 3}]), k3 - 0.1, kByHand);
  EXPECT_NEAR((over[Cell{6, 0}]), k6 - 0.1, kByHand);
  EXPECT_EQ((over[Cell{0, 0}]), 0.0F);
}

/// The table of kTwoWalls: `three` around the wall of 3 dB, `six` around that of 6 dB.
Table aroundTwoWalls(double three, double six) {
  return {{0, 0, 0, 0, 0, 0, 0},
          {0, 0, 0, 0, 0, 0, 0},
          {0, 0, three, three, three, 0, 0},
          {0, 0, three, three, three, 0, 0},
          {0, 0, three, three, three, 0, 0},
          {0, 0, 0, 0, 0, six, six},
          {0, 0, 0, 0, 0, six, six}};
}

TEST(RadioFeatures, WallBesideIsTheMeanOfASquareOfThreeCells) {
  // 1 - exp(-mean / 1.5 dB) for a ninth of 3 and of 6 dB.
  constexpr double k3 = 0.1993, k6 = 0.3588;
  expectTable(featureOf(kTwoWalls, "wall_beside"), aroundTwoWalls(k3, k6));
  expectTable(featureOf(kTwoWalls, "wall_beside_over_0.02"), aroundTwoWalls(k3 - 0.02, k6 - 0.02));
  expectTable(featureOf(kTwoWalls, "wall_beside_over_0.1"), aroundTwoWalls(k3 - 0.1, k6 - 0.1));
}

TEST(RadioFeatures, WallBesideBelowALimitIsNotOverIt) {
  FeatureScene scene{{"X#....."}, 0.2, {"1......"}};
  // A ninth of 1 dB: 0.0714.
  EXPECT_NEAR(featureAtX(scene, "wall_beside_over_0.02"), 0.0514, kByHand);
  EXPECT_EQ(featureAtX(scene, "wall_beside_over_0.1"), 0.0);
}

TEST(RadioFeatures, WayAroundIsWhatTheCheapestWayCostsMoreThanTheStraightOne) {
  // Through half a metre of 1 dB: 1 m more. 1 - exp(-1 m / 0.5 m).
  constexpr double kMore = 0.8647;
  const FeatureScene scene{Picture(7, "#......"), 0.5, Picture(7, "...1...")};
  expectEachRow(featureOf(scene, "way_around"), {0, 0, 0, kMore, kMore, kMore, kMore});
  expectEachRow(featureOf(scene, "way_around_over_0.1"),
                {0, 0, 0, kMore - 0.1, kMore - 0.1, kMore - 0.1, kMore - 0.1});
  expectEachRow(featureOf(scene, "way_around_over_0.25"),
                {0, 0, 0, kMore - 0.25, kMore - 0.25, kMore - 0.25, kMore - 0.25});
}

// ---- Explained: the share of the signals' variance that walls explain ----

/// Signals that obey a log-distance law, less the loss of each ray.
void sendThrough(const std::vector<double>& loss_db, AccessPointBins& access_point) {
  for (std::size_t i = 0; i < access_point.bins.size(); ++i) {
    RadioBin& bin = access_point.bins[i];
    bin.rssi_dbm = -40.0 - 2.0 * logDistance(access_point, bin.position) - loss_db[i];
  }
}

/// A wall between the path and X, and two access points with the same signals. Walls explain those
/// of the first wholly; to the second, which is far away, none were found: a half is explained.
FeatureScene halfExplained() {
  FeatureScene scene{{"#......",  //
                      "#......",  //
                      "#......",  //
                      "#..X...",  //
                      "#......",  //
                      "#......",  //
                      "#......"},
                     0.2,
                     Picture(7, "...3...")};
  std::vector<Cell> bins{{6, 3}};
  for (std::int64_t x = 0; x < 7; ++x) {
    bins.push_back({x, 0});
    bins.push_back({x, 6});
  }
  std::vector<double> loss_db(bins.size(), 0.0);
  loss_db[0] = 4.0;  // of the only ray through X
  loss_db[5] = 9.0;
  scene.access_points = {accessPointAt(scene, {0, 3}, bins)};
  sendThrough(loss_db, scene.access_points.front());
  AccessPointBins far = scene.access_points.front();
  const Position away(100.0, 0.0);
  far.position += away;
  for (RadioBin& bin : far.bins) {
    bin.position += away;
  }
  scene.access_points.push_back(far);
  scene.ray_loss_db = {loss_db, std::vector<double>(bins.size(), 0.0)};
  return scene;
}

TEST(RadioFeatures, ExplainedIsTheShareThatWallsExplain) {
  const FeatureScene scene = halfExplained();
  EXPECT_NEAR(described(scene).explained_variance, 0.5, 1e-6);
  expectTable(featureOf(scene, "explained"), Table(7, std::vector<double>(7, 0.5)), 1e-6);
}

TEST(RadioFeatures, ExplainedTimesAFeatureIsTheirProduct) {
  const FeatureScene scene = halfExplained();
  EXPECT_NEAR(featureAtX(scene, "explained_line_of_sight"), 0.5 * std::exp(-4.0 / 4.0), kByHand);
  EXPECT_NEAR(featureAtX(scene, "explained_wall_strength"), 0.5 * (1 - std::exp(-3.0 / 1.5)),
              kByHand);
  EXPECT_NEAR(featureAtX(scene, "explained_wall_beside"), 0.5 * (1 - std::exp(-1.0 / 1.5)),
              kByHand);
  // 0.2 m of 3 dB: 1.2 m more.
  EXPECT_NEAR(featureAtX(scene, "explained_way_around"), 0.5 * (1 - std::exp(-1.2 / 0.5)), kByHand);
}

TEST(RadioFeatures, ExplainedStaysWithinItsLimits) {
  const FeatureScene scene = halfExplained();
  const auto explained = [&](const CellFeatures& features, const char* name) {
    return featureOf(features, name)[Cell{3, 3}];
  };
  const CellFeatures at_least = described(scene, {0.6, 0.7});
  EXPECT_NEAR(explained(at_least, "explained"), 0.6, kByHand);
  EXPECT_NEAR(explained(at_least, "explained_line_of_sight"), 0.6 * std::exp(-1.0), kByHand);
  EXPECT_NEAR(at_least.explained_variance, 0.5, 1e-6) << "as found, for reports";
  const CellFeatures at_most = described(scene, {0.1, 0.3});
  EXPECT_NEAR(explained(at_most, "explained"), 0.3, kByHand);
  EXPECT_NEAR(explained(at_most, "explained_way_around"), 0.3 * (1 - std::exp(-2.4)), kByHand);
}

}  // namespace
}  // namespace sfw::test
