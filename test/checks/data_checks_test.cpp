#include "structure_from_wifi/data_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "output/report.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

const Position kFirst(2.0, 1.5);
const Position kSecond(6.0, 4.5);

/// Through a hall of 8 x 6 m in lanes 1 m apart, with a reading of two access points at each stamp.
std::vector<Reading> hallDrive() {
  Random random(7, 8, 9);
  std::vector<Reading> readings;
  for (int i = 0; i < 560; ++i) {
    const int lane = i / 80;
    const Position place(0.1 * (lane % 2 == 0 ? i % 80 : 80 - i % 80), lane);
    int number = 0;
    for (const Position& access_point : {kFirst, kSecond}) {
      const double distance = std::max(0.3, (place - access_point).norm());
      const double rssi_dbm = -40.0 - 20.0 * std::log10(distance) + random.normal();
      readings.push_back(test::reading(i, place.x(), place.y(), rssi_dbm, ++number));
    }
  }
  return readings;
}

Mapper mapperOf(const std::vector<AccessPoint>& table) { return {test::rawConfig(), table}; }

void insert(const std::vector<Reading>& readings, std::size_t from, std::size_t to,
            Mapper& mapper) {
  std::for_each(readings.begin() + static_cast<std::ptrdiff_t>(from),
                readings.begin() + static_cast<std::ptrdiff_t>(to),
                [&](const Reading& reading) { mapper.insert(reading); });
}

DataFindings allChecked(const Mapper& mapper) { return DataChecker().checkAll(*mapper.infer()); }

DataFindings changedChecked(DataChecker& checker, const Mapper& mapper) {
  const std::atomic<bool> never{false};
  return checker.checkChanged(*mapper.infer(), never);
}

TEST(DataChecker, SuspectsThePositionThatIsWrong) {
  Mapper mapper =
      mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y()), test::accessPoint(2, 2.0, 4.5)});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  const DataFindings findings = allChecked(mapper);
  ASSERT_TRUE(findings.fits[0]);
  EXPECT_FALSE(findings.fits[0]->suspect);
  ASSERT_TRUE(findings.fits[1]);
  EXPECT_TRUE(findings.fits[1]->suspect);
  EXPECT_LT((findings.fits[1]->estimate.position - kSecond).norm(), 1.0);
}

TEST(DataChecker, ChecksNoAccessPointWithoutGivenPositionOrReadings) {
  AccessPoint to_estimate = test::accessPoint(1, 0.0, 0.0);
  to_estimate.position_known = false;
  Mapper mapper = mapperOf({to_estimate, test::accessPoint(9, 1.0, 1.0)});
  EXPECT_FALSE(allChecked(mapper).fits[1]);
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  const DataFindings findings = allChecked(mapper);
  EXPECT_TRUE(mapper.infer()->access_points[0].estimate);
  EXPECT_FALSE(findings.fits[0]);
  EXPECT_FALSE(findings.fits[1]);
}

TEST(DataChecker, KeepsAFitUntilATenthMoreReadingsCome) {
  Mapper mapper = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, 1000, mapper);
  DataChecker checker;
  const DataFindings first = changedChecked(checker, mapper);
  ASSERT_TRUE(first.fits[0]);
  EXPECT_EQ(first.fits[0]->estimate.readings, 500U);
  insert(readings, 1000, 1090, mapper);
  EXPECT_EQ(changedChecked(checker, mapper).fits[0]->estimate.readings, 500U);
  insert(readings, 1090, 1100, mapper);
  EXPECT_EQ(changedChecked(checker, mapper).fits[0]->estimate.readings, 550U);
}

TEST(DataChecker, StartsAnewAfterAReset) {
  Mapper mapper = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  DataChecker checker;
  ASSERT_TRUE(changedChecked(checker, mapper).fits[0]);
  mapper.reset();
  EXPECT_FALSE(changedChecked(checker, mapper).fits[0]);
}

TEST(DataChecker, JudgesAnewWhatACorrectionMoved) {
  const std::vector<Reading> readings = hallDrive();
  const std::vector<AccessPoint> table{test::accessPoint(1, kFirst.x(), kFirst.y())};
  Mapper mapper = mapperOf(table);
  insert(readings, 0, readings.size(), mapper);
  DataChecker checker;
  const Position before = changedChecked(checker, mapper).fits[0]->estimate.position;
  Mapper moved = mapperOf(table);
  for (Reading reading : readings) {
    reading.antenna_in_map.x() += 3.0;
    moved.insert(reading);
  }
  const DataFindings after = changedChecked(checker, moved);
  EXPECT_TRUE(after.fits[0]->suspect);
  EXPECT_NEAR(after.fits[0]->estimate.position.x(), before.x() + 3.0, 0.3);
}

TEST(DataChecker, JudgesAFewAtATime) {
  std::vector<AccessPoint> table;
  std::vector<Reading> readings;
  for (int number = 1; number <= 6; ++number) {
    table.push_back(test::accessPoint(number, kFirst.x() + 2.0 * number, kFirst.y()));
    for (Reading reading : hallDrive()) {
      if (reading.bssid == test::bssid(1)) {
        reading.bssid = test::bssid(number);
        readings.push_back(reading);
      }
    }
  }
  Mapper mapper = mapperOf(table);
  insert(readings, 0, readings.size(), mapper);
  DataChecker checker;
  const auto checkedIn = [](const DataFindings& findings) {
    return std::count_if(findings.fits.begin(), findings.fits.end(),
                         [](const std::optional<AccessPointFit>& fit) { return bool(fit); });
  };
  const DataFindings first = changedChecked(checker, mapper);
  EXPECT_TRUE(first.unfinished);
  EXPECT_GT(checkedIn(first), 0);
  EXPECT_LT(checkedIn(first), 6);
  const DataFindings second = changedChecked(checker, mapper);
  EXPECT_FALSE(second.unfinished);
  EXPECT_EQ(checkedIn(second), 6);
  EXPECT_EQ(checkedIn(allChecked(mapper)), 6);
}

TEST(DataChecker, ForgetsNoneWhenAllAreMovedAgainAndAgain) {
  std::vector<AccessPoint> table;
  for (int number = 1; number <= 10; ++number) {
    table.push_back(test::accessPoint(number, kFirst.x() + 2.0 * number, kFirst.y()));
  }
  DataChecker checker;
  DataFindings findings;
  for (int correction = 0; correction < 4; ++correction) {
    Mapper mapper = mapperOf(table);
    for (Reading reading : hallDrive()) {
      if (reading.bssid == test::bssid(1)) {
        reading.antenna_in_map.x() += correction;
        for (int number = 1; number <= 10; ++number) {
          reading.bssid = test::bssid(number);
          mapper.insert(reading);
        }
      }
    }
    findings = changedChecked(checker, mapper);
  }
  ASSERT_EQ(findings.fits.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_TRUE(findings.fits[i]) << table[i].bssid.str();
  }
}

TEST(DataChecker, NotesDriftInTheReport) {
  const std::vector<Reading> readings = hallDrive();
  for (const double drift_m : {0.0, 3.0}) {
    Mapper mapper = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
    for (Reading reading : readings) {  // twice over, as if the second drive had drifted
      mapper.insert(reading);
      reading.stamp_ns += 1000000000000;
      reading.antenna_in_map.x() += drift_m;
      mapper.insert(reading);
    }
    const DataFindings findings = allChecked(mapper);
    ASSERT_TRUE(findings.drift);
    EXPECT_EQ(findings.drift->suspect, drift_m > 0.0) << findings.drift->ratio;
    const std::string report = reportJson(*mapper.infer(), Config(), findings);
    EXPECT_EQ(report.find("seems to have drifted") != std::string::npos, drift_m > 0.0);
  }
  Mapper once = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  EXPECT_FALSE(allChecked(once).drift);
}

TEST(DataChecker, StopsWhenAsked) {
  Mapper mapper = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  const std::atomic<bool> stop{true};
  const DataFindings findings = DataChecker().checkAll(*mapper.infer(), stop);
  EXPECT_FALSE(findings.fit(0));
  EXPECT_FALSE(findings.drift);
}

}  // namespace
}  // namespace sfw
