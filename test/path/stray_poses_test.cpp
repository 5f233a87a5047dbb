#include "path/stray_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "structure_from_wifi/map_notes.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

/// A drive along x at 0.5 m/s, a pose each second.
std::vector<PathPose> drive(int poses) {
  std::vector<PathPose> path;
  for (int i = 0; i < poses; ++i) {
    path.push_back({i * kSecond, {0.5 * i, 1.0}, PathPose::kNoWallCount});
  }
  return path;
}

void shift(std::vector<PathPose>& path, std::size_t from, std::size_t to, const Position& by) {
  for (std::size_t i = from; i < to; ++i) {
    path[i].antenna_in_map += by;
  }
}

/// 's' for a stray pose, '.' for one that is believed.
std::string judged(const std::vector<PathPose>& path) {
  std::string text;
  for (const bool stray : strayPoses(path)) {
    text += stray ? 's' : '.';
  }
  return text;
}

TEST(StrayPoses, AreNoneOnADrive) {
  EXPECT_EQ(judged({}), "");
  EXPECT_EQ(judged(drive(1)), ".");
  EXPECT_EQ(judged(drive(12)), "............");
}

TEST(StrayPoses, AreThoseOfAJumpThereAndBack) {
  std::vector<PathPose> path = drive(12);
  shift(path, 5, 8, {300.0, 0.0});
  EXPECT_EQ(judged(path), ".....sss....");
  shift(path, 7, 8, {0.0, -900.0});  // lost in two places one after the other
  EXPECT_EQ(judged(path), ".....sss....");
}

TEST(StrayPoses, AreFoundAtBothEnds) {
  std::vector<PathPose> path = drive(12);
  shift(path, 0, 2, {0.0, 50.0});
  shift(path, 11, 12, {0.0, -50.0});
  EXPECT_EQ(judged(path), "ss.........s");
}

TEST(StrayPoses, AreNoneWhereALocalisationFindsItsPlaceForGood) {
  std::vector<PathPose> path = drive(30);
  shift(path, 15, 30, {40.0, 0.0});
  EXPECT_EQ(judged(path), std::string(30, '.'));
}

TEST(StrayPoses, AreThoseBeforeALocalisationFindsItsPlace) {
  std::vector<PathPose> path = drive(30);
  shift(path, 0, 5, {40.0, 0.0});
  EXPECT_EQ(judged(path), "sssss" + std::string(25, '.'));
}

TEST(StrayPoses, AreNoneWhereThereWasTimeToGoThere) {
  std::vector<PathPose> path = drive(12);
  shift(path, 6, 12, {25.0, 0.0});  // five times as fast as it usually drives
  for (std::size_t i = 6; i < path.size(); ++i) {
    path[i].stamp_ns += 10 * kSecond;
  }
  EXPECT_EQ(judged(path), "............");
}

TEST(StrayPoses, AreThoseThatNoRobotSoSlowCanGetTo) {
  std::vector<PathPose> path = drive(12);
  shift(path, 5, 8, {6.0, 0.0});
  EXPECT_EQ(judged(path), ".....sss....");
  for (PathPose& pose : path) {
    pose.antenna_in_map.x() *= 4.0;  // the same at 2 m/s, and a jump of 24 m
  }
  EXPECT_EQ(judged(path), ".....sss....");
  EXPECT_NEAR(usualSpeed(path), 2.0, 1e-9);
}

TEST(StrayPoses, AreNoneForSmallCorrections) {
  std::vector<PathPose> path = drive(12);
  for (PathPose& pose : path) {
    pose.stamp_ns /= 100;
  }
  shift(path, 4, 5, {0.0, 1.4});
  EXPECT_EQ(judged(path), "............");
}

Mapper mapperWith(const std::vector<Reading>& readings) {
  Config config = test::rawConfig();
  config.method = "tomography";
  Mapper mapper(config, {test::accessPoint(1, 4.0, 4.0)});
  for (const Reading& reading : readings) {
    mapper.insert(reading);
  }
  return mapper;
}

std::vector<Reading> heardOn(const std::vector<PathPose>& path) {
  std::vector<Reading> readings;
  for (const PathPose& pose : path) {
    readings.push_back(test::reading(0, pose.antenna_in_map.x(), pose.antenna_in_map.y(), -50));
    readings.back().stamp_ns = pose.stamp_ns;
  }
  return readings;
}

TEST(StrayPoses, LeaveTheMapAsItIsWithoutThem) {
  std::vector<PathPose> path = drive(30);
  std::vector<PathPose> without = path;
  without.erase(without.begin() + 12);
  shift(path, 12, 13, {300.0, -80.0});
  Mapper mapper = mapperWith(heardOn(path)), other = mapperWith(heardOn(without));
  const Contact believed{5 * kSecond, {2.5, 1.2}}, stray{12 * kSecond + 1, {306.0, -79.0}};
  mapper.insert(believed);
  mapper.insert(stray);
  other.insert(believed);
  const auto snapshot = mapper.infer(), clean = other.infer();
  EXPECT_EQ(trinaryPgm(snapshot->belief), trinaryPgm(clean->belief));
  EXPECT_EQ(snapshot->path.size(), 29U);
  EXPECT_EQ(snapshot->access_points.front().readings, 29U);
  EXPECT_EQ(mapper.geometry(), other.geometry());
  EXPECT_EQ(mapper.readings().size(), 30U);  // a file of them makes the same map again
  EXPECT_EQ(snapshot->stray.count, 1U);
  EXPECT_EQ(snapshot->stray.first_stamp_ns, 12 * kSecond);
  EXPECT_NEAR(snapshot->stray.farthest_m, std::hypot(300.5, 80.0), 1e-6);
}

TEST(StrayPoses, AreReported) {
  std::vector<PathPose> path = drive(30);
  shift(path, 12, 14, {300.0, 0.0});
  const std::vector<MapNote> notes = mapNotes(*mapperWith(heardOn(path)).infer());
  const auto told = std::find_if(notes.begin(), notes.end(), [](const MapNote& note) {
    return note.text.rfind("2 poses are left out with the readings there: up to 301 m away", 0) ==
               0 &&
           note.text.find("at 12.000 s") != std::string::npos;
  });
  EXPECT_NE(told, notes.end());
  EXPECT_EQ(mapNotes(*mapperWith(heardOn(drive(30))).infer()).size(), notes.size() - 1);
}

TEST(StrayPoses, TakeNoRoomFromThoseThatAreRight) {
  // A map from the stray pose to the last one would pass map/max_cells.
  Config config = test::rawConfig();
  config.map.max_cells = 1'000'000;
  Mapper mapper(config, {test::accessPoint(1, 4.0, 4.0)});
  for (int i = 0; i < 400; ++i) {
    const Position at = i == 10 ? Position(500.0, 0.0) : Position(0.0, 0.5 * i);
    Reading reading = test::reading(0, at.x(), at.y(), -50);
    reading.stamp_ns = i * kSecond;
    EXPECT_EQ(mapper.insert(reading), InsertResult::kAccepted) << i;
  }
  EXPECT_EQ(mapper.infer()->path.size(), 399U);
}

}  // namespace
}  // namespace sfw
