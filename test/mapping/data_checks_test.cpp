#include "structure_from_wifi/data_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

const Position kFirst(2.0, 1.5);
const Position kSecond(6.0, 4.5);

/// Through a hall of 8 x 6 m in lanes 1 m apart; two access points heard at each stamp.
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

Snapshot allJudged(const Mapper& mapper) {
  Snapshot snapshot = *mapper.infer();
  DataChecker().checkAll(mapper, snapshot);
  return snapshot;
}

Snapshot changedJudged(DataChecker& judge, const Mapper& mapper) {
  const std::atomic<bool> never{false};
  Snapshot snapshot = *mapper.infer();
  judge.checkChanged(mapper, snapshot, never);
  return snapshot;
}

TEST(DataChecker, SuspectsThePositionThatIsWrong) {
  Mapper mapper =
      mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y()), test::accessPoint(2, 2.0, 4.5)});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  const Snapshot snapshot = allJudged(mapper);
  ASSERT_TRUE(snapshot.access_points[0].fit);
  EXPECT_FALSE(snapshot.access_points[0].fit->suspect);
  ASSERT_TRUE(snapshot.access_points[1].fit);
  EXPECT_TRUE(snapshot.access_points[1].fit->suspect);
  EXPECT_LT((snapshot.access_points[1].fit->estimate.position - kSecond).norm(), 1.0);
}

TEST(DataChecker, DoesNotJudgeWhatNobodyGaveOrHeard) {
  AccessPoint to_estimate = test::accessPoint(1, 0.0, 0.0);
  to_estimate.position_known = false;
  Mapper mapper = mapperOf({to_estimate, test::accessPoint(9, 1.0, 1.0)});
  EXPECT_FALSE(allJudged(mapper).access_points[1].fit);
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  const Snapshot snapshot = allJudged(mapper);
  EXPECT_TRUE(snapshot.access_points[0].estimate);
  EXPECT_FALSE(snapshot.access_points[0].fit);
  EXPECT_FALSE(snapshot.access_points[1].fit);
}

TEST(DataChecker, KeepsAFitUntilATenthMoreIsHeard) {
  Mapper mapper = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, 1000, mapper);
  DataChecker judge;
  const Snapshot first = changedJudged(judge, mapper);
  ASSERT_TRUE(first.access_points[0].fit);
  EXPECT_EQ(first.access_points[0].fit->estimate.readings, 500U);
  insert(readings, 1000, 1090, mapper);
  EXPECT_EQ(changedJudged(judge, mapper).access_points[0].fit->estimate.readings, 500U);
  insert(readings, 1090, 1100, mapper);
  EXPECT_EQ(changedJudged(judge, mapper).access_points[0].fit->estimate.readings, 550U);
}

TEST(DataChecker, StartsAnewAfterAReset) {
  Mapper mapper = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  DataChecker judge;
  ASSERT_TRUE(changedJudged(judge, mapper).access_points[0].fit);
  mapper.reset();
  EXPECT_FALSE(changedJudged(judge, mapper).access_points[0].fit);
}

TEST(DataChecker, JudgesAnewWhatACorrectionMoved) {
  const std::vector<Reading> readings = hallDrive();
  const std::vector<AccessPoint> table{test::accessPoint(1, kFirst.x(), kFirst.y())};
  Mapper mapper = mapperOf(table);
  insert(readings, 0, readings.size(), mapper);
  DataChecker judge;
  const Position before = changedJudged(judge, mapper).access_points[0].fit->estimate.position;
  Mapper moved = mapperOf(table);
  for (Reading reading : readings) {
    reading.antenna_in_map.x() += 3.0;
    moved.insert(reading);
  }
  const Snapshot after = changedJudged(judge, moved);
  EXPECT_TRUE(after.access_points[0].fit->suspect);
  EXPECT_NEAR(after.access_points[0].fit->estimate.position.x(), before.x() + 3.0, 0.3);
}

TEST(DataChecker, JudgesAFewAtATime) {
  std::vector<AccessPoint> table;
  std::vector<Reading> readings;
  for (int number = 1; number <= 6; ++number) {
    table.push_back(test::accessPoint(number, kFirst.x(), kFirst.y()));
    for (Reading reading : hallDrive()) {
      if (reading.bssid == test::bssid(1)) {
        reading.bssid = test::bssid(number);
        readings.push_back(reading);
      }
    }
  }
  Mapper mapper = mapperOf(table);
  insert(readings, 0, readings.size(), mapper);
  DataChecker judge;
  const auto judgedIn = [](const Snapshot& snapshot) {
    return std::count_if(snapshot.access_points.begin(), snapshot.access_points.end(),
                         [](const AccessPointSummary& summary) { return bool(summary.fit); });
  };
  const std::atomic<bool> never{false};
  Snapshot snapshot = *mapper.infer();
  EXPECT_TRUE(judge.checkChanged(mapper, snapshot, never)) << "some are left";
  EXPECT_GT(judgedIn(snapshot), 0);
  EXPECT_LT(judgedIn(snapshot), 6);
  EXPECT_FALSE(judge.checkChanged(mapper, snapshot, never));
  EXPECT_EQ(judgedIn(snapshot), 6);
  EXPECT_EQ(judgedIn(allJudged(mapper)), 6);
}

TEST(DataChecker, ForgetsNoneWhenAllAreMovedAgainAndAgain) {
  std::vector<AccessPoint> table;
  for (int number = 1; number <= 10; ++number) {
    table.push_back(test::accessPoint(number, kFirst.x(), kFirst.y()));
  }
  DataChecker judge;
  Snapshot snapshot = *mapperOf(table).infer();
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
    snapshot = changedJudged(judge, mapper);
  }
  for (const AccessPointSummary& summary : snapshot.access_points) {
    EXPECT_TRUE(summary.fit) << summary.access_point.bssid.str();
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
    const Snapshot snapshot = allJudged(mapper);
    ASSERT_TRUE(snapshot.drift);
    EXPECT_EQ(snapshot.drift->suspect, drift_m > 0.0) << snapshot.drift->ratio;
    const std::string report = reportJson(snapshot, Config());
    EXPECT_EQ(report.find("looks as if it drifted") != std::string::npos, drift_m > 0.0);
  }
  Mapper once = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  EXPECT_FALSE(allJudged(once).drift);
}

TEST(DataChecker, StopsWhenAsked) {
  Mapper mapper = mapperOf({test::accessPoint(1, kFirst.x(), kFirst.y())});
  const std::vector<Reading> readings = hallDrive();
  insert(readings, 0, readings.size(), mapper);
  const std::atomic<bool> stop{true};
  Snapshot snapshot = *mapper.infer();
  DataChecker().checkAll(mapper, snapshot, stop);
  EXPECT_FALSE(snapshot.access_points[0].fit);
}

}  // namespace
}  // namespace sfw
