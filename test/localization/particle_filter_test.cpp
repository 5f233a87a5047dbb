#include "localization/particle_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "localization/heard_hall.h"
#include "localization/odometry_steps.h"

namespace sfw {
namespace {

using Steps = std::vector<std::optional<Position>>;

class ParticleFilterTest : public testing::Test {
 protected:
  HeardHall hall_;
  RadioMap map_{hall_.drive(0.0, 2.0, 0.0), {}};
  std::vector<Scan> drive_ = hall_.drive(1.0, 2.0, 5000.0);

  /// Mean error after the first 20 scans [m].
  double meanError(const Steps& steps, std::int64_t seed = 0) const {
    ParticleFilter::Config config;
    config.seed = seed;
    ParticleFilter filter(map_, config);
    double sum = 0.0;
    for (std::size_t i = 0; i < drive_.size(); ++i) {
      const std::optional<PlaceEstimate> estimate = filter.add(drive_[i], steps[i]);
      sum += i < 20 ? 0.0 : (estimate->position - drive_[i].position).norm();
    }
    return sum / static_cast<double>(drive_.size() - 20);
  }

  double meanErrorOfSingleScans() const {
    double sum = 0.0;
    for (std::size_t i = 20; i < drive_.size(); ++i) {
      const auto log_likelihood = map_.logLikelihood(drive_[i]);
      const PlaceEstimate estimate =
          estimateOf(map_.places().points(), posterior(map_.places(), *log_likelihood));
      sum += (estimate.position - drive_[i].position).norm();
    }
    return sum / static_cast<double>(drive_.size() - 20);
  }

  Steps turnedSteps(double yaw_rad) const {
    std::vector<PathPose> odometry;
    for (const Scan& scan : drive_) {
      PathPose pose;
      pose.stamp_ns = scan.stamp_ns;
      pose.antenna_in_map = Eigen::Rotation2Dd(yaw_rad) * scan.position + Position(50.0, -20.0);
      odometry.push_back(pose);
    }
    return odometrySteps(drive_, odometry);
  }
};

TEST_F(ParticleFilterTest, SeveralScansTellMoreThanOne) {
  EXPECT_LT(meanError(Steps(drive_.size())), 0.8 * meanErrorOfSingleScans());
}

TEST_F(ParticleFilterTest, OdometryHelpsInAnyFrame) {
  const double without = meanError(Steps(drive_.size()));
  EXPECT_LT(meanError(turnedSteps(0.0)), without);
  EXPECT_LT(meanError(turnedSteps(2.0)), without);
}

TEST_F(ParticleFilterTest, SeedsDecideAlone) {
  const Steps none(drive_.size());
  EXPECT_EQ(meanError(none, 3), meanError(none, 3));
  EXPECT_NE(meanError(none, 3), meanError(none, 4));
}

TEST_F(ParticleFilterTest, FindsARobotThatWasCarriedAway) {
  ParticleFilter filter(map_, ParticleFilter::Config());
  double time_s = 9000.0;
  for (int i = 0; i < 20; ++i) {
    filter.add(hall_.scanAt({1.0, 2.0}, time_s++), Position(0.0, 0.0));
  }
  std::optional<PlaceEstimate> estimate;
  for (int i = 0; i < 40; ++i) {
    estimate = filter.add(hall_.scanAt({19.0, 0.25 * i}, time_s++), Position(0.0, 0.25));
  }
  EXPECT_LT((estimate->position - Position(19.0, 9.75)).norm(), 3.0);
}

TEST_F(ParticleFilterTest, TellsHowSureItIs) {
  ParticleFilter filter(map_, ParticleFilter::Config());
  const PlaceEstimate first = *filter.add(drive_[0]);
  PlaceEstimate later;
  for (std::size_t i = 1; i < 60; ++i) {
    later = *filter.add(drive_[i]);
  }
  EXPECT_LT(later.covariance.trace(), first.covariance.trace());
  EXPECT_GE(later.sure, first.sure);
  EXPECT_LE(later.sure, 1.0);
}

TEST_F(ParticleFilterTest, WaitsForARadioOfTheMap) {
  ParticleFilter filter(map_, ParticleFilter::Config());
  Scan strange;
  strange.heard.emplace_back(HeardHall::bssid(9, 9), -50.0);
  EXPECT_FALSE(filter.add(strange));
  EXPECT_TRUE(filter.add(drive_[0]));
  strange.stamp_ns = drive_[0].stamp_ns + 1'000'000'000;
  EXPECT_TRUE(filter.add(strange)) << "the place is still known";
}

TEST(OdometrySteps, AreNoneInGapsAndBeyondTheEnds) {
  std::vector<Scan> scans(4);
  std::vector<PathPose> poses(3);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    scans[i].stamp_ns = 1'000'000'000LL * static_cast<std::int64_t>(i);
  }
  poses[0] = {0, Position(0.0, 0.0)};
  poses[1] = {2'000'000'000, Position(2.0, 0.0)};
  poses[2] = {20'000'000'000, Position(9.0, 0.0)};
  const auto steps = odometrySteps(scans, poses);
  EXPECT_FALSE(steps[0]);
  EXPECT_DOUBLE_EQ(steps[1]->x(), 1.0);
  EXPECT_DOUBLE_EQ(steps[2]->x(), 1.0);
  EXPECT_FALSE(steps[3]);
}

TEST(MotionOf, MeasuresSpeedAndItsTime) {
  const HeardHall hall;
  const Motion motion = motionOf(hall.drive(0.0, 2.0, 0.0));
  EXPECT_NEAR(motion.speed, 0.5, 0.1);
  EXPECT_GT(motion.velocity_time_s, 5.0);
  EXPECT_GT(motionOf({hall.scanAt({0.0, 0.0}, 0.0)}).speed, 0.0);
}

}  // namespace
}  // namespace sfw
