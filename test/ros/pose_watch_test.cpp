#include "ros/mapping/pose_watch.h"

#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <stdexcept>

namespace sfw {
namespace {

constexpr double kPi = 3.14159265358979;

LocatedObservation at(double seconds, double x, double tilt_rad = 0.0, double mounting_rad = 0.0) {
  LocatedObservation observation;
  observation.readings = {{static_cast<std::int64_t>(seconds * 1e9), {x, 0.0}, Bssid(), -50.0}};
  const Eigen::AngleAxisd map_from_base(tilt_rad, Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd base_from_antenna(mounting_rad, Eigen::Vector3d::UnitX());
  observation.up_in_sensor =
      (map_from_base * base_from_antenna).conjugate() * Eigen::Vector3d::UnitZ();
  return observation;
}

TEST(PoseWatch, CountsTiltsAgainstTheFirstPose) {
  for (const double mounting_rad : {0.0, kPi / 2.0, kPi}) {
    PoseWatch watch(0.35, 0.0);
    EXPECT_TRUE(watch.isUsable(at(0.0, 0.0, 0.0, mounting_rad)));
    EXPECT_TRUE(watch.isUsable(at(1.0, 0.1, 0.3, mounting_rad)));
    EXPECT_EQ(watch.tilted(), 0U) << mounting_rad;
    EXPECT_TRUE(watch.isUsable(at(2.0, 0.2, kPi / 6.0, mounting_rad)));
    EXPECT_EQ(watch.tilted(), 1U) << mounting_rad;
    EXPECT_NEAR(watch.largestTilt(), kPi / 6.0, 1e-9);
  }
}

TEST(PoseWatch, DropsAJumpThereAndBackOnly) {
  PoseWatch watch(0.35, 1.0);
  EXPECT_TRUE(watch.isUsable(at(0.0, 0.0)));
  EXPECT_FALSE(watch.isUsable(at(0.5, 50.0)));
  EXPECT_TRUE(watch.isUsable(at(1.0, 0.5)));
  EXPECT_EQ(watch.jumped(), 1U);
}

TEST(PoseWatch, WatchesEachRobotByItself) {
  PoseWatch watch(0.35, 1.0);
  for (int i = 0; i < 5; ++i) {
    LocatedObservation other = at(i, 50.0, 0.0, kPi);
    other.readings[0].robot = "other";
    EXPECT_TRUE(watch.isUsable(at(i, 0.0)));
    EXPECT_TRUE(watch.isUsable(other));
  }
  EXPECT_EQ(watch.tilted(), 0U);
}

TEST(PoseWatch, BelievesAJumpWhenTheRobotCouldHaveGotThere) {
  PoseWatch watch(0.35, 1.0);
  EXPECT_TRUE(watch.isUsable(at(0.0, 0.0)));
  EXPECT_FALSE(watch.isUsable(at(1.0, 50.0)));
  EXPECT_TRUE(watch.isUsable(at(49.5, 50.0)));
  EXPECT_TRUE(watch.isUsable(at(50.0, 50.5)));
}

TEST(PoseWatch, BelievesSmallCorrectionsAndScansOutOfOrder) {
  PoseWatch watch(0.35, 1.0);
  for (const double seconds : {0.0, 3.0, 1.0, 2.0}) {
    EXPECT_TRUE(watch.isUsable(at(seconds, seconds)));
  }
  EXPECT_TRUE(watch.isUsable(at(2.0, 2.9)));
}

TEST(PoseWatch, BelievesEveryPoseWithoutALimitOrAfterAClear) {
  PoseWatch unlimited(0.35, 0.0), watch(0.35, 1.0);
  EXPECT_TRUE(unlimited.isUsable(at(0.0, 0.0)));
  EXPECT_TRUE(unlimited.isUsable(at(0.1, 50.0)));
  EXPECT_TRUE(watch.isUsable(at(0.0, 0.0)));
  watch.clear();
  EXPECT_TRUE(watch.isUsable(at(0.1, 50.0)));
}

}  // namespace
}  // namespace sfw
