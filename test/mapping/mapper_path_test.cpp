// The poses of the path between readings that are far apart.

#include <gtest/gtest.h>

#include <cmath>

#include "structure_from_wifi/mapper.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

constexpr std::int64_t kTenth = 100'000'000;  // [ns]

/// A way around the corner of an L, at 0.5 m/s.
Position wayAt(int tenths) {
  const double way = 0.05 * tenths;
  return way < 3.0 ? Position(1.0 + way, 1.0) : Position(4.0, way - 2.0);
}

/// @param every  tenths of a second from reading to reading
Mapper drivenPast(int every) {
  Mapper mapper(Config(), {test::accessPoint(1, 2.0, 3.0)});
  for (int i = 0; i <= 120; i += every) {
    const double distance = (wayAt(i) - Position(2.0, 3.0)).norm();
    mapper.insert(
        Reading{i * kTenth, wayAt(i), test::bssid(1), -40.0 - 20.0 * std::log10(distance)});
  }
  return mapper;
}

void insertPoses(Mapper& mapper) {
  for (int i = 120; i >= 0; --i) {  // in no order
    mapper.insertPose(i * kTenth, wayAt(i));
  }
}

TEST(MapperPath, PosesMakeFreeWhatTheRobotDroveBetweenTwoReadings) {
  Mapper mapper = drivenPast(60);
  const Position corner = wayAt(60), on_the_way = wayAt(30), later = wayAt(90);
  EXPECT_EQ(test::stateAt(*mapper.infer(), on_the_way), CellState::kUnknown);
  insertPoses(mapper);
  const auto snapshot = mapper.infer();
  for (const Position& point : {corner, on_the_way, later}) {
    EXPECT_EQ(test::stateAt(*snapshot, point), CellState::kFree);
  }
  EXPECT_EQ(snapshot->path.size(), 61U);  // 6 m, each 0.1 m
  EXPECT_FALSE(snapshot->recording.gaps);
}

TEST(MapperPath, DoesNotChangeTheMapOfDenseReadings) {
  Mapper mapper = drivenPast(2);
  const auto before = test::hashOf(mapper);
  insertPoses(mapper);
  EXPECT_EQ(test::hashOf(mapper), before);
}

TEST(MapperPath, IsCorrectedWithTheReadings) {
  Mapper mapper = drivenPast(60);
  insertPoses(mapper);
  PathCorrector corrector;
  for (int i = 0; i <= 120; ++i) {  // odometry that drifts to the left, put right at the end
    const double drift = i < 120 ? 0.0 : -0.5;
    corrector.insert({i * kTenth, wayAt(i) + Position(0.0, drift), {0.0, drift}, 0.0});
  }
  mapper.correct(corrector.correction());
  const std::vector<PathPose> poses = mapper.poses();
  ASSERT_EQ(poses.size(), 121U);
  EXPECT_NEAR(poses[118].antenna_in_map.y(), wayAt(118).y() - 0.49, 0.03);
  EXPECT_NEAR(poses[90].antenna_in_map.y(), wayAt(90).y() - 0.35, 0.05);
}

TEST(MapperPath, IsForgottenAndReset) {
  Mapper mapper = drivenPast(60);
  insertPoses(mapper);
  mapper.forget(
      [](std::int64_t, const Position& point, const std::string&) { return point.x() > 3.9; });
  EXPECT_EQ(mapper.poses().size(), 59U);
  mapper.reset();
  EXPECT_TRUE(mapper.poses().empty());
}

TEST(MapperPath, TakesNoPoseThatNoMapCanHold) {
  Mapper mapper = drivenPast(60);
  const Box extent = mapper.extent();
  EXPECT_EQ(mapper.insertPose(5 * kTenth, {1e7, 0.0}), InsertResult::kPositionTooFar);
  EXPECT_EQ(mapper.insertPose(5 * kTenth, {std::nan(""), 0.0}), InsertResult::kPositionNotFinite);
  EXPECT_TRUE(mapper.poses().empty());
  EXPECT_TRUE(mapper.rejections().count.empty()) << "poses are no readings";
  EXPECT_TRUE(mapper.extent().isApprox(extent));
}

TEST(MapperPath, KeepsTheJudgementOnStrayReadings) {
  Mapper mapper = drivenPast(10);
  mapper.insert(Reading{55 * kTenth, {300.0, 1.0}, test::bssid(1), -50.0});
  for (int i = 50; i <= 60; ++i) {  // tf interpolates to the stray pose and back
    mapper.insertPose(i * kTenth, {1.0 + 60.0 * (5 - std::abs(55 - i)), 1.0});
  }
  const auto snapshot = mapper.infer();
  EXPECT_EQ(snapshot->stray.count, 1U);
  EXPECT_LT(snapshot->extent.max().x(), 10.0);
}

}  // namespace
}  // namespace sfw
