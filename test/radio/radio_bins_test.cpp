#include "radio/radio_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

constexpr double kBin = 0.5;
const Position kAccessPoint(5.0, 5.0);

AccessPointBins binnedHere(const std::vector<Sample>& samples) {
  return binned(samples, kAccessPoint, std::nullopt, BuildingFrame(), kBin);
}

TEST(RadioBins, HoldMeanPlaceMeanSignalAndCount) {
  const AccessPointBins heard =
      binnedHere({{{0.1, 0.1}, -50.0}, {{0.3, 0.2}, -53.0}, {{0.2, 0.3}, -56.0}});
  ASSERT_EQ(heard.bins.size(), 1U);
  EXPECT_NEAR(heard.bins[0].place.x(), 0.2, 1e-12);
  EXPECT_NEAR(heard.bins[0].place.y(), 0.2, 1e-12);
  EXPECT_NEAR(heard.bins[0].rssi_dbm, -53.0, 1e-12);
  EXPECT_EQ(heard.bins[0].readings, 3.0);
  EXPECT_EQ(heard.position, kAccessPoint);
}

TEST(RadioBins, AreInRowMajorOrderOnBothSidesOfTheOrigin) {
  const AccessPointBins heard = binnedHere({{{0.7, 0.7}, -1.0},
                                            {{0.2, 0.7}, -2.0},
                                            {{0.7, 0.2}, -3.0},
                                            {{0.2, -0.2}, -4.0},
                                            {{-0.2, -0.2}, -5.0}});
  std::vector<double> signals;
  for (const RadioBin& bin : heard.bins) {
    signals.push_back(bin.rssi_dbm);
  }
  EXPECT_EQ(signals, (std::vector<double>{-5.0, -4.0, -3.0, -2.0, -1.0}));
}

TEST(RadioBins, LowerEdgesBelongToABin) {
  EXPECT_EQ(binnedHere({{{0.0, 0.0}, -40.0}, {{0.49, 0.49}, -40.0}}).bins.size(), 1U);
  EXPECT_EQ(binnedHere({{{0.0, 0.0}, -40.0}, {{0.5, 0.0}, -40.0}}).bins.size(), 2U);
}

TEST(RadioBins, LeaveOutWhatIsTooNear) {
  const AccessPointBins heard = binnedHere(
      {{kAccessPoint + Position(0.29, 0.0), -20.0}, {kAccessPoint + Position(0.0, -0.31), -21.0}});
  ASSERT_EQ(heard.bins.size(), 1U);
  EXPECT_EQ(heard.bins[0].rssi_dbm, -21.0);
}

TEST(RadioBins, NoiseIsThatOfSuccessiveDifferences) {
  // Differences 2, -3 and 30, which counts as 12: (4 + 9 + 144) / 2 / 3.
  const AccessPointBins heard =
      binnedHere({{{0, 0}, -50.0}, {{0, 0}, -48.0}, {{0, 0}, -51.0}, {{0, 0}, -81.0}});
  EXPECT_NEAR(heard.noise_db2, 157.0 / 6.0, 1e-12);
}

TEST(RadioBins, NoiseIsNeverNothing) {
  EXPECT_DOUBLE_EQ(binnedHere({{{0, 0}, -50.0}, {{0, 0}, -50.0}}).noise_db2, 0.09);
  EXPECT_DOUBLE_EQ(binnedHere({{{0, 0}, -50.0}}).noise_db2, 0.09);
  EXPECT_DOUBLE_EQ(binnedHere({}).noise_db2, 0.09);
  EXPECT_TRUE(binnedHere({}).bins.empty());
}

TEST(RadioBins, OrderMattersOnlyToNoise) {
  std::vector<Sample> samples;
  for (int i = 0; i < 200; ++i) {
    samples.push_back({{0.07 * (i % 31), 0.11 * (i % 17)}, -40.0 - i % 13});
  }
  const AccessPointBins heard = binnedHere(samples);
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.rssi_dbm < b.rssi_dbm; });
  const AccessPointBins sorted = binnedHere(samples);
  ASSERT_EQ(sorted.bins.size(), heard.bins.size());
  for (std::size_t i = 0; i < heard.bins.size(); ++i) {
    EXPECT_LT((sorted.bins[i].place - heard.bins[i].place).norm(), 1e-12);
    EXPECT_NEAR(sorted.bins[i].rssi_dbm, heard.bins[i].rssi_dbm, 1e-12);
    EXPECT_EQ(sorted.bins[i].readings, heard.bins[i].readings);
  }
  EXPECT_LT(sorted.noise_db2, 0.1 * heard.noise_db2);
}

TEST(RadioBins, LieInTheBuildingFrame) {
  const BuildingFrame frame{0.3, BuildingFrame::Source::kHeadings};
  const AccessPointBins turned =
      binned({{frame.toMap({0.2, 0.3}), -50.0}}, frame.toMap(kAccessPoint), 2.0, frame, kBin);
  EXPECT_LT((turned.position - kAccessPoint).norm(), 1e-12);
  ASSERT_EQ(turned.bins.size(), 1U);
  EXPECT_LT((turned.bins[0].place - Position(0.2, 0.3)).norm(), 1e-12);
  EXPECT_EQ(turned.height_m, 2.0);
}

TEST(LogDistance, IsThatInSpaceAndAtLeastThirtyCentimetres) {
  AccessPointBins heard;
  EXPECT_NEAR(logDistance(heard, {3.0, 4.0}), 10.0 * std::log10(5.0), 1e-12);
  EXPECT_NEAR(logDistance(heard, {0.0, 0.0}), 10.0 * std::log10(0.3), 1e-12);
  heard.height_m = 2.6;
  EXPECT_NEAR(logDistance(heard, {1.5, 0.0}), 10.0 * std::log10(2.5), 1e-12);
}

/// Bins on a straight line that leads away, with a wall of 8 dB after half of them.
AccessPointBins heardThroughAWall(double exponent) {
  std::vector<Sample> samples;
  for (int i = 2; i < 22; ++i) {
    const double distance = 0.5 * i + 0.25;
    samples.push_back(
        {kAccessPoint + Position(distance, 0.25),
         -40.0 - 10.0 * exponent * std::log10(std::hypot(distance, 0.25)) - (i < 12 ? 0.0 : 8.0)});
  }
  return binnedHere(samples);
}

std::vector<double> lossBehind(const AccessPointBins& heard, double loss_db) {
  std::vector<double> losses;
  for (const RadioBin& bin : heard.bins) {
    losses.push_back(bin.place.x() - kAccessPoint.x() < 6.0 ? 0.0 : loss_db);
  }
  return losses;
}

TEST(ExplainedShare, IsOneWhereWallsExplainAllAndNoneWhereTheyExplainNothing) {
  const AccessPointBins heard = heardThroughAWall(2.0);
  EXPECT_NEAR(explainedVariance({heard}, {lossBehind(heard, 8.0)}), 1.0, 1e-9);
  EXPECT_EQ(explainedVariance({heard}, {lossBehind(heard, 0.0)}), 0.0);
  EXPECT_EQ(explainedVariance({heard}, {lossBehind(heard, -8.0)}), 0.0);  // worse than nothing
  const double half = explainedVariance({heard}, {lossBehind(heard, 4.0)});
  EXPECT_GT(half, 0.6);
  EXPECT_LT(half, 0.9);
}

TEST(ExplainedShare, LeavesOutWhatIsHardlyHeard) {
  AccessPointBins heard = heardThroughAWall(2.0);
  heard.bins.resize(9);
  EXPECT_EQ(explainedVariance({heard}, {lossBehind(heard, 8.0)}), 0.0);
  EXPECT_EQ(explainedVariance({}, {}), 0.0);
}

}  // namespace
}  // namespace sfw
