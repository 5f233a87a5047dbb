#include "path/poses_between.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "path/odometry_checks.h"

namespace sfw {
namespace {

constexpr std::int64_t kTenth = 100'000'000;  // [ns]

PathPose pose(int tenths, double x, double y) { return {tenths * kTenth, {x, y}}; }

/// A drive along x at 0.5 m/s: a reading each 4 s, a pose each 0.1 s.
struct Drive {
  std::vector<PathPose> readings;
  std::vector<PathPose> poses;

  explicit Drive(int seconds, int between_readings = 4) {
    for (int i = 0; i <= 10 * seconds; ++i) {
      (i % (10 * between_readings) == 0 ? readings : poses).push_back(pose(i, 0.05 * i, 1.0));
    }
  }

  std::vector<PathPose> kept() const {
    return posesBetween(readings, std::vector<bool>(readings.size(), false), poses);
  }
};

TEST(PosesBetween, FillALongWayInSteps) {
  const std::vector<PathPose> kept = Drive(4).kept();
  ASSERT_EQ(kept.size(), 19U);  // 2 m, each 0.1 m
  EXPECT_NEAR(kept.front().antenna_in_map.x(), 0.1, 1e-9);
  EXPECT_NEAR(kept.back().antenna_in_map.x(), 1.9, 1e-9);
}

TEST(PosesBetween, AreNoneWhereReadingsAreDense) {
  Drive drive(4);
  drive.readings.clear();
  for (int i = 0; i <= 40; i += 2) {  // each 0.1 m
    drive.readings.push_back(pose(i, 0.05 * i, 1.0));
  }
  EXPECT_TRUE(drive.kept().empty());
}

TEST(PosesBetween, AreNoneBeforeTheFirstAndAfterTheLastReading) {
  Drive drive(12);
  drive.readings = {drive.readings[1], drive.readings[2]};
  for (const PathPose& kept : drive.kept()) {
    EXPECT_GT(kept.stamp_ns, 40 * kTenth);
    EXPECT_LT(kept.stamp_ns, 80 * kTenth);
  }
  EXPECT_EQ(drive.kept().size(), 19U);
}

TEST(PosesBetween, ShowAWayThatLeadsBack) {
  Drive drive(4);
  drive.readings = {pose(0, 0.0, 1.0), pose(40, 0.0, 1.0)};
  for (PathPose& one : drive.poses) {
    one.antenna_in_map.x() = std::min(one.antenna_in_map.x(), 2.0 - one.antenna_in_map.x());
  }
  double farthest = 0.0;
  for (const PathPose& kept : drive.kept()) {
    farthest = std::max(farthest, kept.antenna_in_map.x());
  }
  EXPECT_NEAR(farthest, 1.0, 0.11);
}

TEST(PosesBetween, AreNoneBesideAStrayReading) {
  const Drive drive(12);
  const std::vector<PathPose> kept =
      posesBetween(drive.readings, {false, true, false, false}, drive.poses);
  ASSERT_EQ(kept.size(), 19U);
  EXPECT_GT(kept.front().stamp_ns, 80 * kTenth);
}

TEST(PosesBetween, AreLeftOutWhereTheRobotCannotHaveBeen) {
  Drive drive(4);
  drive.poses[20].antenna_in_map = {300.0, 1.0};
  for (const PathPose& kept : drive.kept()) {
    EXPECT_LT(kept.antenna_in_map.x(), 2.0);
  }
  EXPECT_GE(drive.kept().size(), 18U);
}

// ---- Whether corrections are those of an odometry ----

OdometryCorrection fix(int i, double x, double odom_x) {
  return {i * kTenth, {x, 0.0}, {odom_x, 0.0}, 0.0};
}

bool areTrusted(const std::vector<OdometryCorrection>& corrections) {
  return areOfOdometry(corrections, PathCorrector::Tolerance());
}

TEST(OdometryChecks, TrustADriftThatLoopClosuresTakeOff) {
  std::vector<OdometryCorrection> corrections;
  for (int i = 0; i < 100; ++i) {
    corrections.push_back(fix(i, 0.1 * i, -0.3 * (i / 20)));
  }
  EXPECT_TRUE(areTrusted(corrections));
  EXPECT_TRUE(areTrusted({}));
}

TEST(OdometryChecks, DoNotTrustAFrameThatGoesToAndFro) {
  std::vector<OdometryCorrection> corrections;
  for (int i = 0; i < 100; ++i) {
    corrections.push_back(fix(i, 0.05 * i + (i % 2 == 0 ? 0.0 : 1.5), i % 2 == 0 ? 0.0 : 1.5));
  }
  EXPECT_FALSE(areTrusted(corrections));
}

TEST(OdometryChecks, DoNotTrustAFrameThatIsFixedToTheRobot) {
  std::vector<OdometryCorrection> corrections;
  for (int i = 0; i < 100; ++i) {
    corrections.push_back(fix(i, 0.1 * i, 0.1 * i - 0.2));
  }
  EXPECT_FALSE(areTrusted(corrections));
}

}  // namespace
}  // namespace sfw
