#include "localization/pose_graph.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "base/constants.h"

namespace sfw {
namespace {

constexpr int kStepsOfASide = 20;
constexpr int kRound = 4 * kStepsOfASide;

/// Twice around a square of 10 m, by steps of half a metre. Each step turns by an error.
std::vector<Position> twoRounds(double turn_error_rad) {
  std::vector<Position> path{Position::Zero()};
  for (int step = 0; step < 2 * kRound; ++step) {
    const int side = step / kStepsOfASide % 4;
    const double heading_rad = 0.5 * kPi * side + turn_error_rad * step;
    path.push_back(path.back() + Eigen::Rotation2Dd(heading_rad) * Position(0.5, 0.0));
  }
  return path;
}

/// The second round passes the places of the first one.
std::vector<LoopConstraint> closings() {
  std::vector<LoopConstraint> all;
  for (std::size_t i = 0; i < kRound; i += 4) {
    all.push_back({i, i + kRound, Position::Zero(), 0.04});
  }
  return all;
}

double largestDistance(const std::vector<Position>& path, const std::vector<Position>& truth) {
  double largest = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    largest = std::max(largest, (path[i] - truth[i]).norm());
  }
  return largest;
}

TEST(Trajectory, OfClosingsIsTheTrueOne) {
  const std::vector<Position> truth = twoRounds(0.0);
  const std::vector<Position> odometry = twoRounds(0.004);
  ASSERT_GT(largestDistance(odometry, truth), 4.0);
  const Trajectory path =
      optimizedTrajectory(odometry, closings(), {}, odometryTrajectory(odometry));
  EXPECT_LT(largestDistance(path.positions, truth), 1.5);
  for (const LoopConstraint& closing : closings()) {
    EXPECT_LT(squaredMisfit(closing, path.positions), 1.0);
  }
}

TEST(Trajectory, WithoutClosingsIsThatOfTheOdometry) {
  const std::vector<Position> odometry = twoRounds(0.004);
  const Trajectory path = optimizedTrajectory(odometry, {}, {}, odometryTrajectory(odometry));
  EXPECT_LT(largestDistance(path.positions, odometry), 1e-9);
  EXPECT_DOUBLE_EQ(strainOf(odometry, path, {}), 0.0);
}

TEST(Trajectory, GivesWrongClosingsLittleWeight) {
  const std::vector<Position> truth = twoRounds(0.0);
  std::vector<LoopConstraint> some_wrong = closings();
  for (std::size_t i = 0; i < some_wrong.size(); i += 5) {
    some_wrong[i].offset = {8.0, 3.0};
  }
  const Trajectory path = optimizedTrajectory(truth, some_wrong, {}, odometryTrajectory(truth));
  EXPECT_LT(largestDistance(path.positions, truth), 0.3);
}

TEST(Trajectory, IsStrainedByClosingsThatOdometryContradicts) {
  const std::vector<Position> odometry = twoRounds(0.0);
  std::vector<LoopConstraint> shrunk;
  for (std::size_t i = 0; i < kRound; i += 4) {
    const Position across = odometry[i + kRound / 2] - odometry[i];
    shrunk.push_back({i, i + kRound / 2, 0.7 * across, 1.0});
  }
  const Trajectory path = optimizedTrajectory(odometry, shrunk, {}, odometryTrajectory(odometry));
  EXPECT_GT(strainOf(odometry, path, {}), 10.0);
}

TEST(Extend, ContinuesWithTheLastTurn) {
  const std::vector<Position> odometry{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  Trajectory path{{{0.0, 0.0}, {1.0, 0.0}}, {0.0, 0.5 * kPi}};
  extend(odometry, path);
  ASSERT_EQ(path.positions.size(), 3U);
  EXPECT_NEAR((path.positions[2] - Position(1.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(path.turns_rad[2], 0.5 * kPi);
}

}  // namespace
}  // namespace sfw
