#include "localization/scan_difference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "localization/heard_hall.h"

namespace sfw {
namespace {

/// Scans one metre apart that hear some radios.
std::vector<Scan> scansOf(const std::vector<std::vector<std::pair<int, double>>>& heard) {
  std::vector<Scan> scans;
  for (const auto& radios : heard) {
    Scan scan;
    scan.position.x() = static_cast<double>(scans.size());
    for (const auto& [radio, rssi_dbm] : radios) {
      scan.heard.emplace_back(HeardHall::bssid(radio, 0), rssi_dbm);
    }
    scans.push_back(scan);
  }
  return scans;
}

TEST(ScanDifference, IsTheMeanSquareOfTheRadiosThatEitherHears) {
  const std::vector<std::pair<int, double>> usual{{0, -40.0}, {1, -50.0}, {2, -60.0}};
  const std::vector<std::pair<int, double>> weaker{{0, -43.0}, {1, -50.0}, {2, -60.0}};
  const std::vector<std::pair<int, double>> without{{0, -40.0}, {1, -50.0}};
  const ScanDifference difference(
      scansOf({usual, usual, usual, usual, usual, weaker, without, {{0, -40.0}}, {{0, -40.0}}}));
  EXPECT_DOUBLE_EQ(difference.between(0, 1), 0.0);
  EXPECT_DOUBLE_EQ(difference.between(0, 5), 3.0);
  // Silence is 2 dB below the weakest signal.
  EXPECT_NEAR(difference.between(0, 6), 4.0 / 3.0, 1e-6);
  EXPECT_TRUE(std::isinf(difference.between(7, 8))) << "one radio of three is too little";
}

TEST(ScanDifference, OfNeighboursIsThatWhichAFifthExceeds) {
  const std::vector<std::pair<int, double>> usual{{0, -40.0}, {1, -50.0}, {2, -60.0}};
  const std::vector<std::pair<int, double>> other{{0, -46.0}, {1, -50.0}, {2, -60.0}};
  std::vector<std::vector<std::pair<int, double>>> heard(31, usual);
  heard[3] = heard[9] = other;  // 4 of 30 pairs differ
  EXPECT_DOUBLE_EQ(ScanDifference(scansOf(heard)).usualOfNeighbours(scansOf(heard)), 0.0);
  heard[15] = heard[21] = heard[27] = other;  // 10 of 30
  EXPECT_DOUBLE_EQ(ScanDifference(scansOf(heard)).usualOfNeighbours(scansOf(heard)), 12.0);
}

TEST(ScanDifference, OfFewNeighboursIsUnknown) {
  const std::vector<Scan> scans = scansOf(
      std::vector<std::vector<std::pair<int, double>>>(5, {{0, -40.0}, {1, -50.0}, {2, -60.0}}));
  EXPECT_EQ(ScanDifference(scans).usualOfNeighbours(scans), 0.0);
}

}  // namespace
}  // namespace sfw
