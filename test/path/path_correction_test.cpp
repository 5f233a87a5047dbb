#include "structure_from_wifi/path_correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.h"
#include "support/mapper_scene.h"

namespace sfw {
namespace {

/// A drive as it was, as odometry had it, and as the localisation had it at each time.
struct Drive {
  std::vector<Position> truth;
  std::vector<OdometryCorrection> fixes;
};

constexpr std::int64_t kStep = 200000000;  // [ns]
constexpr double kStepWay = 0.1;           // [m]

Position turned(double angle_rad, const Position& vector) {
  return Eigen::Rotation2Dd(angle_rad) * vector;
}

/// Three times around a rectangle by odometry that stretches and turns in proportion to the way;
/// the odometry's frame is the map's until a loop closure at the step `closure` puts all right.
Drive driftingDrive(double stretch, double turn_per_metre, int closure, int steps) {
  Drive drive;
  Position truth(2.0, 1.0), odom = truth;
  double yaw_rad = 0.0, odom_yaw_rad = 0.0;
  OdometryCorrection fix;
  for (int i = 0; i < steps; ++i) {
    if (i > 0 && i % 50 == 0) {
      yaw_rad += kPi / 2;
      odom_yaw_rad += kPi / 2;
    }
    if (i > 0) {
      truth += turned(yaw_rad, {kStepWay, 0.0});
      odom_yaw_rad += turn_per_metre * kStepWay;
      odom += turned(odom_yaw_rad, {(1.0 + stretch) * kStepWay, 0.0});
    }
    if (i == closure) {
      fix.odom_yaw_rad = yaw_rad - odom_yaw_rad;
      fix.odom_in_map = truth - turned(fix.odom_yaw_rad, odom);
    }
    fix.stamp_ns = 1000000000 + i * kStep;
    fix.antenna_in_map = fix.odom_in_map + turned(fix.odom_yaw_rad, odom);
    drive.truth.push_back(truth);
    drive.fixes.push_back(fix);
  }
  return drive;
}

PathCorrection correctionOf(const std::vector<OdometryCorrection>& fixes) {
  PathCorrector anchor;
  for (const OdometryCorrection& fix : fixes) {
    anchor.insert(fix);
  }
  return anchor.correction();
}

std::vector<Position> correctedPath(const std::vector<OdometryCorrection>& fixes) {
  const PathCorrection correction = correctionOf(fixes);
  std::vector<Position> path;
  for (const OdometryCorrection& fix : fixes) {
    path.push_back(correction.moved(fix.stamp_ns, fix.antenna_in_map));
  }
  return path;
}

/// The largest distance from the truth [m].
double worst(const std::vector<Position>& path, const std::vector<Position>& truth) {
  double distance = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    distance = std::max(distance, (path[i] - truth[i]).norm());
  }
  return distance;
}

std::vector<Position> pathOf(const std::vector<OdometryCorrection>& fixes) {
  std::vector<Position> path;
  for (const OdometryCorrection& fix : fixes) {
    path.push_back(fix.antenna_in_map);
  }
  return path;
}

TEST(PathCorrector, ALoopClosureTakesTheDriftOffTheWholeWay) {
  const Drive drive = driftingDrive(0.0, 0.005, 599, 600);
  EXPECT_GT(worst(pathOf(drive.fixes), drive.truth), 0.5);
  EXPECT_LT(worst(correctedPath(drive.fixes), drive.truth), 0.03);
}

TEST(PathCorrector, AStretchedWayComesOutRightAtBothEnds) {
  // A straight way, on which 4 % too much is 0.2 m at the end.
  const Drive drive = driftingDrive(0.04, 0.0, 49, 50);
  EXPECT_NEAR(worst(pathOf(drive.fixes), drive.truth), 0.19, 0.02);
  EXPECT_LT(worst(correctedPath(drive.fixes), drive.truth), 0.005);
}

TEST(PathCorrector, AfterTheJumpTfIsBelieved) {
  const Drive drive = driftingDrive(0.0, 0.005, 400, 600);
  const std::vector<Position> path = correctedPath(drive.fixes);
  EXPECT_LT(worst({path.begin(), path.begin() + 400}, drive.truth), 0.03);
  for (std::size_t i = 400; i < path.size(); ++i) {
    EXPECT_EQ(path[i], drive.fixes[i].antenna_in_map) << i;
  }
}

TEST(PathCorrector, ASecondClosureMovesOnlyTheWaySinceTheFirst) {
  Drive drive = driftingDrive(0.0, 0.005, 300, 600);
  const std::vector<Position> before = correctedPath(drive.fixes);
  for (std::size_t i = 590; i < drive.fixes.size(); ++i) {
    drive.fixes[i].odom_in_map += Position(0.0, 0.3);
    drive.fixes[i].antenna_in_map += Position(0.0, 0.3);
  }
  const std::vector<Position> after = correctedPath(drive.fixes);
  for (std::size_t i = 0; i <= 300; ++i) {
    EXPECT_EQ(after[i], before[i]) << i;
  }
  EXPECT_NEAR((after[445] - before[445]).y(), 0.15, 0.01);
  EXPECT_NEAR((after[589] - before[589]).y(), 0.3, 0.01);
}

TEST(PathCorrector, WithoutAJumpNothingMovesByABit) {
  Drive drive = driftingDrive(0.01, 0.002, 600, 600);
  for (std::size_t i = 0; i < drive.fixes.size(); ++i) {  // as amcl goes along: steps of 2 cm
    const Position step(0.02 * static_cast<double>(i % 7), -0.01 * static_cast<double>(i % 3));
    drive.fixes[i].odom_in_map += step;
    drive.fixes[i].antenna_in_map += step;
    drive.fixes[i].odom_in_map.x() -= i % 7 == 6 ? 0.06 : 0.0;
    drive.fixes[i].antenna_in_map.x() -= i % 7 == 6 ? 0.06 : 0.0;
  }
  EXPECT_TRUE(correctionOf(drive.fixes).empty());
  EXPECT_EQ(correctedPath(drive.fixes), pathOf(drive.fixes));
}

TEST(PathCorrector, OrderAndRepetitionDoNotMatter) {
  const Drive drive = driftingDrive(0.01, 0.005, 400, 600);
  std::vector<OdometryCorrection> shuffled;
  for (std::size_t i = 0; i < drive.fixes.size(); ++i) {
    shuffled.push_back(drive.fixes[(i * 7) % drive.fixes.size()]);
    shuffled.push_back(drive.fixes[(i * 77) % drive.fixes.size()]);
  }
  const PathCorrection sorted = correctionOf(drive.fixes), mixed = correctionOf(shuffled);
  EXPECT_FALSE(sorted.empty());
  for (const OdometryCorrection& fix : drive.fixes) {
    EXPECT_EQ(sorted.moved(fix.stamp_ns, fix.antenna_in_map),
              mixed.moved(fix.stamp_ns, fix.antenna_in_map));
  }
}

TEST(PathCorrector, AJumpThatTfInterpolatesIsOneJump) {
  const Drive drive = driftingDrive(0.0, 0.005, 500, 501);
  std::vector<OdometryCorrection> fixes = drive.fixes;
  const OdometryCorrection& later = fixes[500];
  OdometryCorrection& between = fixes[499];  // 40 % on the way from one correction to the other
  const Position odom = between.antenna_in_map;
  between.odom_yaw_rad = 0.4 * later.odom_yaw_rad;
  between.odom_in_map = 0.4 * later.odom_in_map;
  between.antenna_in_map = between.odom_in_map + turned(between.odom_yaw_rad, odom);
  EXPECT_LT(worst(correctedPath(fixes), drive.truth), 0.03);
}

TEST(PathCorrector, AJumpThereAndBackAtOnceMovesOnlyWhatLiesBetween) {
  Drive drive = driftingDrive(0.0, 0.0, 0, 100);
  for (std::size_t i = 50; i < 53; ++i) {
    drive.fixes[i].odom_in_map += Position(2.0, 1.0);
    drive.fixes[i].antenna_in_map += Position(2.0, 1.0);
  }
  EXPECT_LT(worst(correctedPath(drive.fixes), drive.truth), 1e-9);
}

TEST(PathCorrector, AWrongPoseAtTheStartMovesAllAlike) {
  std::vector<OdometryCorrection> fixes;
  for (int i = 0; i < 20; ++i) {  // 1 m driven, then the localisation finds itself 9 m away
    const Position step = i < 19 ? Position(0.0, 0.0) : Position(9.0, 0.0);
    fixes.push_back({(i + 1) * kStep, Position(0.05 * i, 0.0) + step, step, 0.0});
  }
  const std::vector<Position> path = correctedPath(fixes);
  EXPECT_NEAR((path[0] - Position(9.0, 0.0)).norm(), 0.0, 0.15);
  EXPECT_NEAR((path[18] - Position(9.9, 0.0)).norm(), 0.0, 0.01);
}

TEST(PathCorrector, FindsAJumpThatPosesBetweenReadingsDivideIntoSmallSteps) {
  PathCorrector corrector;
  for (int i = 0; i <= 100;
       ++i) {  // a reading each 2 s, a pose each 0.2 s, tf interpolates for 2 s
    const double odom_y = 0.05 * std::max(0, i - 90);
    OdometryCorrection fix{i * kStep, {kStepWay * i, odom_y}, {0.0, odom_y}, 0.0};
    fix.is_between = i % 10 != 0;
    corrector.insert(fix);
  }
  const PathCorrection correction = corrector.correction();
  for (const int i : {40, 45, 50, 80, 90, 95}) {
    const double tf_y = 0.05 * std::max(0, i - 90);
    const Position moved = correction.moved(i * kStep, {kStepWay * i, tf_y});
    EXPECT_NEAR(moved.y(), 0.5 * i / 100.0, 0.01) << i;
    EXPECT_NEAR(moved.x(), kStepWay * i, 0.01) << i;
  }
}

TEST(PathCorrector, AJumpOfARobotAtRestMovesAllAlike) {
  const std::vector<OdometryCorrection> fixes = {{kStep, {1.0, 0.0}, {0.0, 0.0}, 0.0},
                                                 {2 * kStep, {0.0, 3.0}, {0.0, 2.0}, kPi / 2}};
  const PathCorrection correction = correctionOf(fixes);
  EXPECT_LT((correction.moved(kStep, {1.0, 0.0}) - Position(0.0, 3.0)).norm(), 1e-12);
  // What it touched 0.2 m ahead turns with it.
  EXPECT_LT((correction.moved(kStep, {1.2, 0.0}) - Position(0.0, 3.2)).norm(), 1e-12);
  EXPECT_EQ(correction.moved(2 * kStep, {0.0, 3.2}), Position(0.0, 3.2));
  EXPECT_EQ(correction.moved(3 * kStep, {7.0, 7.0}), Position(7.0, 7.0)) << "a time without fix";
}

TEST(PathCorrector, LeavesOutWhatIsNotFinite) {
  PathCorrector anchor;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  anchor.insert({kStep, {nan, 0.0}, {0.0, 0.0}, 0.0});
  anchor.insert({kStep, {0.0, 0.0}, {0.0, nan}, 0.0});
  anchor.insert({kStep, {0.0, 0.0}, {0.0, 0.0}, nan});
  EXPECT_EQ(anchor.size(), 0U);
  EXPECT_TRUE(anchor.correction().empty());
}

TEST(CorrectedMapper, CountsReadingsThatNoMapCanHold) {
  Mapper driven = test::mapperOf({});
  PathCorrector anchor;
  for (const Reading& reading : test::drive()) {
    driven.insert(reading);
    anchor.insert({reading.stamp_ns, reading.antenna_in_map, Position::Zero(), 0.0});
  }
  const Position far_out(5e5, 0.0);
  anchor.insert({100000000000, Position(4.0, 2.0) + far_out, far_out, 0.0});
  driven.insert(Contact{test::drive().front().stamp_ns, {0.2, 1.0}});
  driven.correct(anchor.correction());
  EXPECT_EQ(driven.readings().size(), 0U);
  EXPECT_EQ(driven.contacts().size(), 0U);
  EXPECT_EQ(driven.rejections().count.at(InsertResult::kPositionTooFar), test::drive().size() + 1);
}

TEST(CorrectedMapper, MovesReadingsAndContactsAndKeepsTheGeometry) {
  Mapper driven = test::mapperOf(test::drive());
  driven.insert(Contact{0, {0.23, 1.02}});
  PathCorrector anchor;
  for (const Reading& reading : driven.readings()) {
    anchor.insert({reading.stamp_ns, reading.antenna_in_map, Position::Zero(), 0.0});
  }
  anchor.insert({100000000000, {33.93, 2.02}, {30.0, 0.0}, 0.0});
  const Mapper before = driven;
  driven.correct(anchor.correction());
  ASSERT_EQ(driven.readings().size(), before.readings().size());
  for (std::size_t i = 0; i < driven.readings().size(); i += 10) {
    EXPECT_GT(driven.readings()[i].antenna_in_map.x(),
              before.readings()[i].antenna_in_map.x() + 25.0);
  }
  const Position contact = driven.contacts().front().point_in_map;
  EXPECT_NEAR(contact.x() - driven.readings().front().antenna_in_map.x(), 0.2, 1e-3);
  EXPECT_GT(driven.geometry().size(), before.geometry().size());

  Mapper grown = before;
  grown.growTo(driven.extent());
  EXPECT_EQ(grown.geometry().size(), driven.geometry().size());
  EXPECT_EQ(grown.geometry().origin(), driven.geometry().origin());
}

TEST(PathCorrection, MovesEachRobotAsIfItWereAlone) {
  const Drive a = driftingDrive(0.02, 0.0, 500, 600), b = driftingDrive(-0.03, 0.001, 300, 600);
  std::vector<OdometryCorrection> both;  // at the same stamps
  for (std::size_t i = 0; i < a.fixes.size(); ++i) {
    both.push_back(a.fixes[i]);
    both.back().robot = "a";
    both.push_back(b.fixes[i]);
    both.back().robot = "b";
  }
  const PathCorrection together = correctionOf(both);
  const PathCorrection alone_a = correctionOf(a.fixes), alone_b = correctionOf(b.fixes);
  EXPECT_FALSE(alone_a.empty());
  for (std::size_t i = 0; i < a.fixes.size(); ++i) {
    const OdometryCorrection &of_a = a.fixes[i], &of_b = b.fixes[i];
    EXPECT_EQ(together.moved(of_a.stamp_ns, of_a.antenna_in_map, "a"),
              alone_a.moved(of_a.stamp_ns, of_a.antenna_in_map));
    EXPECT_EQ(together.moved(of_b.stamp_ns, of_b.antenna_in_map, "b"),
              alone_b.moved(of_b.stamp_ns, of_b.antenna_in_map));
    EXPECT_EQ(together.moved(of_b.stamp_ns, of_b.antenna_in_map), of_b.antenna_in_map);
  }
}

}  // namespace
}  // namespace sfw
