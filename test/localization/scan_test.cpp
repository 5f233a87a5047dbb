#include "localization/scan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "localization/heard_hall.h"
#include "localization/motion.h"

namespace sfw {
namespace {

Reading reading(double stamp_s, double x, int radio, double rssi_dbm) {
  return {std::llround(1e9 * stamp_s), Position(x, 0.0), HeardHall::bssid(radio, 0), rssi_dbm};
}

TEST(ScansOf, GroupsReadingsOfAShortTimeAndAveragesABssid) {
  std::vector<Reading> readings = {reading(0.0, 1.0, 0, -40.0), reading(0.2, 2.0, 0, -50.0),
                                   reading(0.3, 3.0, 1, -60.0), reading(0.7, 4.0, 1, -70.0)};
  std::reverse(readings.begin(), readings.end());
  const std::vector<Scan> scans = scansOf(readings, 500'000'000);
  ASSERT_EQ(scans.size(), 2U);
  ASSERT_EQ(scans[0].heard.size(), 2U);
  EXPECT_EQ(scans[0].stamp_ns, 0);
  EXPECT_DOUBLE_EQ(scans[0].heard[0].second, -45.0);
  EXPECT_DOUBLE_EQ(scans[0].position.x(), 2.0);
  EXPECT_DOUBLE_EQ(scans[1].heard[0].second, -70.0);
  EXPECT_EQ(wayOf(scans), std::vector<double>({0.0, 2.0}));
}

TEST(StretchesOf, GroupsReadingsOfAShortWay) {
  const std::vector<Scan> stretches =
      stretchesOf({reading(0.0, 0.0, 0, -40.0), reading(9.0, 0.4, 0, -44.0),
                   reading(9.1, 0.6, 0, -50.0), reading(9.2, 0.0, 0, -60.0)},
                  0.5);
  ASSERT_EQ(stretches.size(), 3U);
  EXPECT_DOUBLE_EQ(stretches[0].position.x(), 0.2);
  EXPECT_DOUBLE_EQ(stretches[0].heard[0].second, -42.0);
  EXPECT_EQ(stretches[1].stamp_ns, 9'100'000'000);
}

TEST(ScansOf, KeepRobotsApart) {
  std::vector<Reading> readings = {reading(0.0, 1.0, 0, -40.0), reading(0.1, 9.0, 0, -80.0),
                                   reading(5.0, 2.0, 0, -50.0), reading(5.1, 8.0, 0, -70.0)};
  readings[1].robot = readings[3].robot = "second";
  const std::vector<Scan> scans = scansOf(readings, 500'000'000);
  ASSERT_EQ(scans.size(), 4U);
  EXPECT_DOUBLE_EQ(scans[1].position.x(), 2.0);
  EXPECT_DOUBLE_EQ(scans[2].position.x(), 9.0);
  const Motion motion = motionOf(scans);  // 1 m in 5 s, both
  EXPECT_EQ(motion.velocities.size(), 2U);
  EXPECT_NEAR(motion.speed, 0.2, 1e-3);
}

Scan scanOf(const std::vector<double>& rssi_dbm) {
  Scan scan;
  for (std::size_t i = 0; i < rssi_dbm.size(); ++i) {
    scan.heard.emplace_back(HeardHall::bssid(static_cast<int>(i), 0), rssi_dbm[i]);
  }
  return scan;
}

TEST(WithoutRepeated, LeavesOutTheValuesOfACache) {
  const Scan before = scanOf({-40, -41, -42, -43, -44, -45, -46, -47});
  const Scan after = scanOf({-40, -41, -42, -43, -44, -55, -56, -57});
  const Scan fresh = withoutRepeated(after, before);
  ASSERT_EQ(fresh.heard.size(), 3U);
  EXPECT_EQ(fresh.heard[0].second, -55.0);
  EXPECT_EQ(fresh.repeated.size(), 5U);
}

TEST(WithoutRepeated, KeepsValuesThatAreEqualByChance) {
  const Scan before = scanOf({-40, -41, -42, -43, -44, -45, -46, -47});
  const Scan after = scanOf({-40, -41, -42, -43, -54, -55, -56, -57});
  EXPECT_EQ(withoutRepeated(after, before).heard.size(), 8U);
}

}  // namespace
}  // namespace sfw
