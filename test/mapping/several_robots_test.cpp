// Readings of several robots in one map.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "belief/drive_features.h"
#include "mapping/inliers.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

constexpr std::int64_t kTenth = 100'000'000;  // [ns]
constexpr int kTenths = 160;

/// Both robots drive 8 m around an L, each in its own part of the building.
Position wayAt(const std::string& robot, int tenths) {
  const double way = 0.05 * tenths;
  const Position at = way < 4.0 ? Position(1.0 + way, 1.0) : Position(5.0, way - 3.0);
  return robot == "a" ? at : Position(13.0 - at.x(), 9.0 - at.y());
}

double rssiAt(const Position& position, const Position& access_point, int tenths) {
  const double wall_db = position.x() < 6.5 ? 0.0 : 8.0;
  return -40.0 - 20.0 * std::log10(1.0 + (position - access_point).norm()) - wall_db +
         0.5 * (tenths * 7919 % 5 - 2);
}

std::vector<AccessPoint> table() {
  return {test::accessPoint(1, 2.0, 4.0), test::accessPoint(2, 10.0, 5.0)};
}

std::vector<Reading> driveOf(const std::string& robot) {
  std::vector<Reading> readings;
  for (int i = 0; i < kTenths; ++i) {
    const Position at = wayAt(robot, i);
    for (const AccessPoint& access_point : table()) {
      readings.push_back(
          {i * kTenth, at, access_point.bssid, rssiAt(at, access_point.position, i), robot});
    }
  }
  return readings;
}

Mapper mapperOf(const std::vector<std::vector<Reading>>& drives, const Config& config = {}) {
  Mapper mapper(config, table());
  for (std::size_t i = 0; i < drives.front().size(); ++i) {  // as they arrive
    for (const std::vector<Reading>& drive : drives) {
      EXPECT_EQ(mapper.insert(drive[i]), InsertResult::kAccepted);
    }
  }
  return mapper;
}

std::uint64_t hashOf(const Snapshot& snapshot) {
  return test::hashOf(trinaryPgm(snapshot.belief) + probabilityPgm(snapshot.probability));
}

Mapper atOnce(const Config& config = {}) { return mapperOf({driveOf("a"), driveOf("b")}, config); }

/// One robot drives both ways.
Mapper oneAfterTheOther(const Config& config) {
  std::vector<Reading> first = driveOf("a"), second = driveOf("b");
  for (Reading& reading : second) {
    reading.stamp_ns += 1000 * kTenth;
  }
  first.insert(first.end(), second.begin(), second.end());
  for (Reading& reading : first) {
    reading.robot = {};
  }
  return mapperOf({first}, config);
}

TEST(SeveralRobots, AtOnceMapAsOneRobotThatDrivesBothWays) {
  for (const char* method : {"tomography", "k_visibility"}) {
    Config config;
    config.method = method;
    config.k_visibility.window = 1;  // a longer one joins the end of a drive and the next begin
    EXPECT_EQ(hashOf(*atOnce(config).infer()), hashOf(*oneAfterTheOther(config).infer())) << method;
  }
}

TEST(SeveralRobots, HaveNoFaultOfOneThatIsInTwoPlaces) {
  const auto snapshot = atOnce().infer();
  EXPECT_EQ(snapshot->path.size(), std::size_t{2 * kTenths});
  EXPECT_EQ(snapshot->stray.count, 0U);
  EXPECT_EQ(snapshot->motion.jumps, 0U);
  EXPECT_NEAR(snapshot->motion.usual_speed_m_s, 0.5, 0.01);
  EXPECT_FALSE(snapshot->recording.overlap);
  EXPECT_FALSE(snapshot->recording.bursts);
  EXPECT_FALSE(snapshot->recording.cached);
  EXPECT_FALSE(snapshot->recording.gaps);
  EXPECT_FALSE(snapshot->recording.units);

  std::vector<std::vector<Reading>> nameless{driveOf("a"), driveOf("b")};
  for (std::vector<Reading>& drive : nameless) {
    for (Reading& reading : drive) {
      reading.robot = {};
    }
  }
  const auto taken_for_one = mapperOf(nameless).infer();
  EXPECT_NE(hashOf(*taken_for_one), hashOf(*snapshot));
  EXPECT_TRUE(taken_for_one->recording.overlap || taken_for_one->stray.count > 0 ||
              taken_for_one->stamped_alike > 0);
}

TEST(SeveralRobots, AStrayPoseIsJudgedOnThePathOfItsRobot) {
  Mapper mapper = atOnce();
  const Position elsewhere = wayAt("b", 10);  // where the other robot is
  mapper.insert(Contact{10 * kTenth + 1, wayAt("a", 10), "a"});
  mapper.insert(Contact{10 * kTenth + 1, wayAt("b", 10) + Position(0.0, 0.3), "b"});
  mapper.insert(Reading{10 * kTenth + 1, elsewhere, test::bssid(1), -50.0, "a"});
  const auto snapshot = mapper.infer();
  EXPECT_EQ(snapshot->stray.count, 1U);
  ASSERT_EQ(snapshot->contacts.size(), 1U) << "only that of the stray pose is left out";
  EXPECT_EQ(snapshot->contacts[0].robot, "b");
}

TEST(SeveralRobots, AContactIsForgottenWhenAnyRobotDrivesOverItLater) {
  Mapper mapper = atOnce();
  mapper.insert(Contact{10 * kTenth, wayAt("b", 100), "a"});
  mapper.insert(Contact{110 * kTenth, wayAt("b", 100), "a"});
  const auto snapshot = mapper.infer();
  ASSERT_EQ(snapshot->contacts.size(), 1U);
  EXPECT_EQ(snapshot->contacts[0].stamp_ns, 110 * kTenth);
}

TEST(SeveralRobots, PosesFillTheWayOfTheirRobotOnly) {
  Mapper mapper(Config(), table());
  for (const std::string robot : {"a", "b"}) {
    for (const Reading& reading : driveOf(robot)) {
      if (reading.stamp_ns % (40 * kTenth) == 0) {
        mapper.insert(reading);
      }
    }
  }
  for (int i = 0; i < kTenths; ++i) {
    mapper.insertPose(i * kTenth, wayAt("b", i), "b");
  }
  const auto snapshot = mapper.infer();
  EXPECT_EQ(test::stateAt(*snapshot, wayAt("b", 60)), CellState::kFree);
  EXPECT_EQ(test::stateAt(*snapshot, wayAt("a", 20)), CellState::kUnknown);
}

TEST(SeveralRobots, NoWayJoinsTwoThatMeet) {
  const auto crossedBetween = [](const std::string& second) {
    std::vector<PathPose> path;
    for (int i = 0; i <= 30; ++i) {
      path.push_back({i * kTenth, {1.0 + 0.1 * i, 1.0}, PathPose::kNoWallCount, "a"});
    }
    for (int i = 0; i <= 30; ++i) {
      path.push_back({(40 + i) * kTenth, {4.0 - 0.1 * i, 1.6}, PathPose::kNoWallCount, second});
    }
    const GridGeometry geometry =
        GridGeometry::covering(Box(Position(0, 0), Position(5, 3)), 0.1, 0.1, 100000);
    constexpr double kMaxGap = 1.0;
    const Mask crossed = cellsCrossed(geometry, positionsOf(path, kMaxGap), kMaxGap);
    return static_cast<int>(crossed[geometry.cellAt({4.02, 1.32})]);
  };
  EXPECT_EQ(crossedBetween("a"), 1);
  EXPECT_EQ(crossedBetween("b"), 0);
}

TEST(SeveralRobots, ReadingsOfOneRadioAtOneStampAllCount) {
  Mapper mapper(Config(), table());
  mapper.insert(Reading{0, {1.0, 1.0}, test::bssid(1), -50.0, "a"});
  mapper.insert(Reading{0, {3.0, 1.0}, test::bssid(1), -60.0, "b"});
  mapper.insert(Reading{0, {3.0, 1.0}, test::bssid(1), -70.0, "b"});  // repeated
  EXPECT_EQ(mapper.readings().size(), 2U);
  EXPECT_EQ(mapper.infer()->stamped_alike, 0U);
}

}  // namespace
}  // namespace sfw
