#include "exploration/explorer.h"

#include <gtest/gtest.h>

#include "exploration/exploration_scene.h"

namespace sfw::test {
namespace {

/// Drives straight to a place, in steps of 0.1 m at 0.5 m/s.
void driveTo(Explorer& explorer, const Position& place, double& now_s) {
  while ((explorer.pose().position - place).norm() > 0.05) {
    const Position way = place - explorer.pose().position;
    RobotPose pose = explorer.pose();
    pose.position += way.normalized() * std::min(way.norm(), 0.1);
    now_s += 0.2;
    explorer.addPose(pose, now_s);
  }
}

/// Drives to goals until there are none. The map stays as it is.
void exploreAll(Explorer& explorer, double& now_s) {
  int goals = 0;
  while (const auto goal = explorer.next()) {
    ASSERT_LT(++goals, 100);
    driveTo(explorer, goal->position, now_s);
  }
}

TEST(Explorer, WaitsForPoseAndMap) {
  Explorer explorer({}, {});
  EXPECT_FALSE(explorer.next());
  explorer.addPose({}, 0.0);
  EXPECT_FALSE(explorer.next());
  explorer.setMap(knownSquare(1.0));
  EXPECT_TRUE(explorer.next());
  EXPECT_EQ(explorer.phase(), Explorer::Phase::kExploring);
  EXPECT_EQ(explorer.ending(), "");
}

TEST(Explorer, DoesNotTryAGoalAgainThatFailed) {
  Explorer explorer({}, {});
  explorer.addPose({}, 0.0);
  explorer.setMap(knownSquare(1.0));
  const auto first = explorer.next();
  ASSERT_TRUE(first);
  explorer.giveUp();
  const auto second = explorer.next();
  ASSERT_TRUE(second);
  EXPECT_GT((second->position - first->position).norm(), 0.5);
}

TEST(Explorer, GoesOnAfterManyGoalsThatFailed) {
  Explorer explorer({}, {});
  explorer.addPose({}, 0.0);
  explorer.setMap(knownSquare(3.0));
  std::vector<Position> failed;
  for (int i = 0; i < 12; ++i) {
    const auto goal = explorer.next();
    ASSERT_TRUE(goal) << i;
    for (const Position& other : failed) {
      EXPECT_GE((goal->position - other).norm(), 0.5);
    }
    failed.push_back(goal->position);
    explorer.giveUp();
  }
}

TEST(Explorer, ReturnsHomeWhenItsTimeIsUp) {
  Explorer::Limits limits;
  limits.time_s = 60.0;
  Explorer explorer({}, limits);
  double now_s = 100.0;
  explorer.addPose({}, now_s);
  explorer.setMap(knownSquare(3.0));
  exploreAll(explorer, now_s);
  EXPECT_EQ(explorer.phase(), Explorer::Phase::kFinished);
  EXPECT_LT(explorer.pose().position.norm(), 0.3);
  EXPECT_EQ(explorer.ending(), "the budget is used up");
  EXPECT_LT(now_s, 100.0 + 75.0);
}

TEST(Explorer, EndsWhereItStandsWithoutAReturn) {
  Explorer::Limits limits;
  limits.way_m = 5.0;
  limits.return_home = false;
  Explorer explorer({}, limits);
  double now_s = 0.0;
  explorer.addPose({}, now_s);
  explorer.setMap(knownSquare(1.0));
  exploreAll(explorer, now_s);
  EXPECT_EQ(explorer.phase(), Explorer::Phase::kFinished);
  EXPECT_LE(explorer.driven(), 5.5);
}

TEST(Explorer, EndsWhenNothingIsWorthADrive) {
  Explorer explorer({}, {});
  explorer.addPose({}, 0.0);
  explorer.setMap(knownSquare(0.9));
  // It touches the walls around itself.
  for (const Position& ahead : {Position(1, 0), Position(0, 1), Position(-1, 0), Position(0, -1)}) {
    const Position aside(-ahead.y(), ahead.x());
    for (double s = -1.0; s <= 1.0; s += 0.1) {
      explorer.addPose({0.85 * ahead + s * aside, 0.0}, 1.0);
      explorer.addTouch(ahead + s * aside);
    }
  }
  explorer.addPose({}, 2.0);
  EXPECT_FALSE(explorer.next());
  EXPECT_EQ(explorer.phase(), Explorer::Phase::kFinished);
  EXPECT_EQ(explorer.ending(), "nothing more is worth a drive");
}

}  // namespace
}  // namespace sfw::test
