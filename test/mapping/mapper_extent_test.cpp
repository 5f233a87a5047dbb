#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <vector>

#include "structure_from_wifi/path_correction.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

using namespace test;

/// A mapper whose map may be 16 m long and 8 m wide, with an access point at (4, 4).
Mapper smallMapper() {
  Config config = rawConfig();  // edges lie on multiples of 8 m, 80 cells
  config.map.max_cells = 160 * 80;
  return {config, {accessPoint(1, 4.0, 4.0)}};
}

/// A slow drive of 2 m along y = 4.
std::vector<Reading> driveFrom(double x_m) {
  std::vector<Reading> readings;
  for (int i = 0; i <= 20; ++i) {
    readings.push_back(reading(i, x_m + 0.1 * i, 4.0, -40.0));
  }
  return readings;
}

void insertAll(const std::vector<Reading>& readings, Mapper& mapper) {
  for (const Reading& one : readings) {
    EXPECT_EQ(mapper.insert(one), InsertResult::kAccepted) << one.antenna_in_map.x();
  }
}

/// The correction after a drive that turned out to be displaced along x.
PathCorrection shiftBy(double x_m, const std::vector<Reading>& readings) {
  PathCorrector corrector;
  for (const Reading& one : readings) {
    corrector.insert({one.stamp_ns, one.antenna_in_map, Position::Zero(), 0.0});
  }
  const Reading& last = readings.back();
  const Position shift(x_m, 0.0);
  corrector.insert({last.stamp_ns + 5'000'000'000, last.antenna_in_map + shift, shift, 0.0});
  return corrector.correction();
}

const Reading kRight = reading(1000, -6.0, 4.0, -40.0);
const Reading kTooFarForAnyMap = reading(900, 1000.0, 4.0, -40.0);

TEST(MapperExtent, GivesBackTheRoomOfAStrayPose) {
  std::vector<Reading> readings = driveFrom(3.0);
  readings[10].antenna_in_map.x() = 12.0;
  Mapper mapper = smallMapper();
  insertAll(readings, mapper);
  EXPECT_EQ(mapper.insert(kRight), InsertResult::kAccepted);
}

TEST(MapperExtent, GivesBackTheRoomOfAStrayPoseAfterAReset) {
  std::vector<Reading> readings = driveFrom(3.0);
  readings[10].antenna_in_map.x() = 12.0;
  Mapper mapper = smallMapper();
  insertAll(readings, mapper);
  EXPECT_EQ(mapper.insert(kTooFarForAnyMap), InsertResult::kPositionTooFar);
  mapper.reset();
  insertAll(readings, mapper);
  EXPECT_EQ(mapper.insert(kRight), InsertResult::kAccepted);
}

TEST(MapperExtent, GivesBackTheRoomThatACorrectionLeft) {
  const std::vector<Reading> readings = driveFrom(10.0);
  Mapper mapper = smallMapper();
  insertAll(readings, mapper);
  EXPECT_EQ(mapper.insert(kTooFarForAnyMap), InsertResult::kPositionTooFar);
  mapper.correct(shiftBy(-8.0, readings));
  EXPECT_EQ(mapper.insert(kRight), InsertResult::kAccepted);
}

TEST(MapperExtent, KeepsADriveThatACorrectionMovesToTheOtherSide) {
  // The map can hold the drive at its old position or at its new one, but not at both.
  const std::vector<Reading> readings = driveFrom(-6.0);
  Mapper mapper = smallMapper();
  insertAll(readings, mapper);
  mapper.insert(Contact{readings.front().stamp_ns, {-6.0, 4.2}});
  mapper.correct(shiftBy(16.0, readings));
  EXPECT_EQ(mapper.readings().size(), readings.size());
  EXPECT_EQ(mapper.contacts().size(), 1U);
  EXPECT_TRUE(mapper.rejections().count.empty());
  EXPECT_EQ(mapper.geometry(), GridGeometry(0.1, {0.0, 0.0}, 160, 80));
}

TEST(MapperExtent, DropsOnlyTheStrayPoseThatACorrectionLeavesNoRoomFor) {
  std::vector<Reading> readings = driveFrom(3.0);
  readings[10].antenna_in_map.x() = -6.0;
  Mapper mapper = smallMapper();
  insertAll(readings, mapper);
  mapper.correct(shiftBy(-8.0, driveFrom(3.0)));  // the stray pose comes to x = -13.9
  EXPECT_EQ(mapper.rejections().count,
            (std::map<InsertResult, std::size_t>{{InsertResult::kPositionTooFar, 1}}));
  const std::vector<Reading> kept = mapper.readings();
  EXPECT_EQ(kept.size(), readings.size() - 1);
  for (const Reading& one : kept) {
    EXPECT_GT(one.antenna_in_map.x(), -6.0) << one.stamp_ns;
  }
}

TEST(MapperExtent, CopiesGoTheirOwnWay) {
  Mapper mapper = smallMapper();
  insertAll(driveFrom(3.0), mapper);
  Mapper copy = mapper;
  insertAll({kRight}, copy);
  EXPECT_EQ(copy.readings().size(), mapper.readings().size() + 1);
  mapper = copy;
  EXPECT_EQ(mapper.geometry(), copy.geometry());
}

}  // namespace
}  // namespace sfw
