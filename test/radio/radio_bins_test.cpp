#include "radio/radio_bins.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sfw {
namespace {

constexpr double kBin = 0.5;
const Position kAccessPoint(5.0, 5.0);

AccessPointBins binsOf(const std::vector<Sample>& samples) {
  return binSamples(samples, kAccessPoint, std::nullopt, BuildingFrame(), kBin);
}

TEST(RadioBins, HoldMeanPositionMeanSignalAndCount) {
  const AccessPointBins binned =
      binsOf({{{0.1, 0.1}, -50.0}, {{0.3, 0.2}, -53.0}, {{0.2, 0.3}, -56.0}});
  ASSERT_EQ(binned.bins.size(), 1U);
  EXPECT_NEAR(binned.bins[0].position.x(), 0.2, 1e-12);
  EXPECT_NEAR(binned.bins[0].position.y(), 0.2, 1e-12);
  EXPECT_NEAR(binned.bins[0].rssi_dbm, -53.0, 1e-12);
  EXPECT_EQ(binned.bins[0].readings, 3.0);
  EXPECT_EQ(binned.position, kAccessPoint);
}

TEST(RadioBins, AreFoundForTheirSamples) {
  const BuildingFrame frame{0.3, BuildingFrame::Source::kHeadings};
  std::vector<Sample> samples;
  for (int i = 0; i < 60; ++i) {
    samples.push_back({{0.11 * (i % 20), 0.7 * (i / 20)}, -40.0 - i});
  }
  samples.push_back({kAccessPoint, -20.0});  // too near for a bin
  const AccessPointBins binned = binSamples(samples, kAccessPoint, std::nullopt, frame, kBin);
  const std::vector<std::size_t> bin_of = binsOfSamples(samples, binned, frame, kBin);
  ASSERT_EQ(bin_of.size(), samples.size());
  EXPECT_EQ(bin_of.back(), binned.bins.size());
  std::vector<double> readings(binned.bins.size());
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    ASSERT_LT(bin_of[i], binned.bins.size());
    const Position away =
        binned.bins[bin_of[i]].position - frame.toBuilding(samples[i].antenna_in_map);
    EXPECT_LE(away.cwiseAbs().maxCoeff(), kBin);
    readings[bin_of[i]] += 1.0;
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(readings[i], binned.bins[i].readings);
  }
}

TEST(RadioBins, AreInRowMajorOrderOnBothSidesOfTheOrigin) {
  const AccessPointBins binned = binsOf({{{0.7, 0.7}, -1.0},
                                         {{0.2, 0.7}, -2.0},
                                         {{0.7, 0.2}, -3.0},
                                         {{0.2, -0.2}, -4.0},
                                         {{-0.2, -0.2}, -5.0}});
  std::vector<double> signals;
  for (const RadioBin& bin : binned.bins) {
    signals.push_back(bin.rssi_dbm);
  }
  EXPECT_EQ(signals, (std::vector<double>{-5.0, -4.0, -3.0, -2.0, -1.0}));
}

TEST(RadioBins, LowerEdgesBelongToABin) {
  EXPECT_EQ(binsOf({{{0.0, 0.0}, -40.0}, {{0.49, 0.49}, -40.0}}).bins.size(), 1U);
  EXPECT_EQ(binsOf({{{0.0, 0.0}, -40.0}, {{0.5, 0.0}, -40.0}}).bins.size(), 2U);
}

TEST(RadioBins, DropReadingsNearTheAccessPoint) {
  const AccessPointBins binned = binsOf(
      {{kAccessPoint + Position(0.29, 0.0), -20.0}, {kAccessPoint + Position(0.0, -0.31), -21.0}});
  ASSERT_EQ(binned.bins.size(), 1U);
  EXPECT_EQ(binned.bins[0].rssi_dbm, -21.0);
}

TEST(RadioBins, NoiseIsThatOfSuccessiveDifferences) {
  // Differences 2, -3 and 30, which counts as 12: (4 + 9 + 144) / 2 / 3.
  const AccessPointBins binned =
      binsOf({{{0, 0}, -50.0}, {{0, 0}, -48.0}, {{0, 0}, -51.0}, {{0, 0}, -81.0}});
  EXPECT_NEAR(binned.noise_db2, 157.0 / 6.0, 1e-12);
}

TEST(RadioBins, NoiseIsNeverZero) {
  EXPECT_DOUBLE_EQ(binsOf({{{0, 0}, -50.0}, {{0, 0}, -50.0}}).noise_db2, 0.09);
  EXPECT_DOUBLE_EQ(binsOf({{{0, 0}, -50.0}}).noise_db2, 0.09);
  EXPECT_DOUBLE_EQ(binsOf({}).noise_db2, 0.09);
  EXPECT_TRUE(binsOf({}).bins.empty());
}

TEST(RadioBins, OrderChangesOnlyTheNoise) {
  std::vector<Sample> samples;
  for (int i = 0; i < 200; ++i) {
    samples.push_back({{0.07 * (i % 31), 0.11 * (i % 17)}, -40.0 - i % 13});
  }
  const AccessPointBins binned = binsOf(samples);
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.rssi_dbm < b.rssi_dbm; });
  const AccessPointBins sorted = binsOf(samples);
  ASSERT_EQ(sorted.bins.size(), binned.bins.size());
  for (std::size_t i = 0; i < binned.bins.size(); ++i) {
    EXPECT_LT((sorted.bins[i].position - binned.bins[i].position).norm(), 1e-12);
    EXPECT_NEAR(sorted.bins[i].rssi_dbm, binned.bins[i].rssi_dbm, 1e-12);
    EXPECT_EQ(sorted.bins[i].readings, binned.bins[i].readings);
  }
  EXPECT_LT(sorted.noise_db2, 0.1 * binned.noise_db2);
}

TEST(RadioBins, LieInTheBuildingFrame) {
  const BuildingFrame frame{0.3, BuildingFrame::Source::kHeadings};
  const AccessPointBins turned =
      binSamples({{frame.toMap({0.2, 0.3}), -50.0}}, frame.toMap(kAccessPoint), 2.0, frame, kBin);
  EXPECT_LT((turned.position - kAccessPoint).norm(), 1e-12);
  ASSERT_EQ(turned.bins.size(), 1U);
  EXPECT_LT((turned.bins[0].position - Position(0.2, 0.3)).norm(), 1e-12);
  EXPECT_EQ(turned.height_m, 2.0);
}

TEST(RadioBins, GivePositionsAndNoiseOfTheirMeans) {
  AccessPointBins access_point;
  access_point.noise_db2 = 6.0;
  access_point.bins = {{{1.0, 2.0}, -50.0, 1.0}, {{3.0, 4.0}, -60.0, 3.0}};
  EXPECT_EQ(positionsOf(access_point), (std::vector<Position>{{1.0, 2.0}, {3.0, 4.0}}));
  EXPECT_EQ(noiseOfMeans(access_point), (std::vector<double>{6.0, 2.0}));
}

}  // namespace
}  // namespace sfw
