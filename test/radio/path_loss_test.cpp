#include "radio/path_loss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sfw {
namespace {

const Position kAccessPoint(5.0, 5.0);

TEST(SpaceDistance, AddsTheRiseToTheAccessPoint) {
  const double level = antennaToAccessPoint(std::nullopt);
  EXPECT_DOUBLE_EQ(spaceDistance(0.0, level), 0.3);
  EXPECT_DOUBLE_EQ(spaceDistance(2.25, level), 1.5);
  EXPECT_DOUBLE_EQ(spaceDistance(25.0, level), 5.0);
  EXPECT_DOUBLE_EQ(spaceDistance(2.25, antennaToAccessPoint(2.6)), 2.5);
}

TEST(LogDistance, IsThatInSpaceAndAtLeastThirtyCentimetres) {
  AccessPointBins access_point;
  EXPECT_NEAR(logDistance(access_point, {3.0, 4.0}), 10.0 * std::log10(5.0), 1e-12);
  EXPECT_NEAR(logDistance(access_point, {0.0, 0.0}), 10.0 * std::log10(0.3), 1e-12);
  access_point.height_m = 2.6;
  EXPECT_NEAR(logDistance(access_point, {1.5, 0.0}), 10.0 * std::log10(2.5), 1e-12);
}

/// Bins on a straight line that leads away, with a wall of 8 dB after half of them.
AccessPointBins binsBehindAWall(double exponent) {
  std::vector<Sample> samples;
  for (int i = 2; i < 22; ++i) {
    const double distance = 0.5 * i + 0.25;
    samples.push_back(
        {kAccessPoint + Position(distance, 0.25),
         -40.0 - 10.0 * exponent * std::log10(std::hypot(distance, 0.25)) - (i < 12 ? 0.0 : 8.0)});
  }
  return binSamples(samples, kAccessPoint, std::nullopt, BuildingFrame(), 0.5);
}

std::vector<double> lossOfTheWall(const AccessPointBins& access_point, double loss_db) {
  std::vector<double> losses;
  for (const RadioBin& bin : access_point.bins) {
    losses.push_back(bin.position.x() - kAccessPoint.x() < 6.0 ? 0.0 : loss_db);
  }
  return losses;
}

TEST(ExplainedVariance, IsOneIfWallsExplainAllAndZeroIfTheyExplainNothing) {
  const AccessPointBins access_point = binsBehindAWall(2.0);
  EXPECT_NEAR(explainedVariance({access_point}, {lossOfTheWall(access_point, 8.0)}), 1.0, 1e-9);
  EXPECT_EQ(explainedVariance({access_point}, {lossOfTheWall(access_point, 0.0)}), 0.0);
  EXPECT_EQ(explainedVariance({access_point}, {lossOfTheWall(access_point, -8.0)}),
            0.0);  // worse than nothing
  const double half = explainedVariance({access_point}, {lossOfTheWall(access_point, 4.0)});
  EXPECT_GT(half, 0.6);
  EXPECT_LT(half, 0.9);
}

TEST(ExplainedVariance, SkipsAccessPointsOfFewBins) {
  AccessPointBins access_point = binsBehindAWall(2.0);
  access_point.bins.resize(9);
  EXPECT_EQ(explainedVariance({access_point}, {lossOfTheWall(access_point, 8.0)}), 0.0);
  EXPECT_EQ(explainedVariance({}, {}), 0.0);
}

}  // namespace
}  // namespace sfw
