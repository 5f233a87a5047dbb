#include <gtest/gtest.h>

#include "exploration/exploration_scene.h"
#include "structure_from_wifi/exploration.h"
#include "structure_from_wifi/input_error.h"
#include "support/complaint.h"

namespace sfw::test {
namespace {

const RobotPose kHere{};

TEST(Goals, LieAtTheBorderOfWhatIsKnown) {
  const std::vector<ExplorationGoal> goals = rankGoals(knownSquare(1.5), kHere, {}, 5);
  ASSERT_EQ(goals.size(), 5u);
  for (const ExplorationGoal& goal : goals) {
    EXPECT_GT(goal.position.cwiseAbs().maxCoeff(), 1.0);
    EXPECT_EQ(goal.way.front(), kHere.position);
    EXPECT_LT((goal.way.back() - goal.position).norm(), 1e-9);
    EXPECT_GT(goal.area_m2, 0.15);
    EXPECT_GT(goal.travel_s, goal.position.norm() / ExplorationConfig().speed_m_s - 0.3);
  }
}

TEST(Goals, AreRankedAndApart) {
  const std::vector<ExplorationGoal> goals = rankGoals(knownSquare(1.0), kHere, {}, 8);
  for (std::size_t i = 0; i < goals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE(goals[j].rate_m2_s, goals[i].rate_m2_s);
      EXPECT_GE((goals[j].position - goals[i].position).norm(), 1.0);
    }
  }
}

TEST(Goals, AreNoneWhereTouchedWallsEnclose) {
  ExplorationView view = knownSquare(1.1);
  touchAlong(view, {-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0});
  touchAlong(view, {-1.0, 1.0}, {1.0, 1.0}, {0.0, -1.0});
  touchAlong(view, {-1.0, -1.0}, {-1.0, 1.0}, {1.0, 0.0});
  touchAlong(view, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 0.0});
  EXPECT_TRUE(rankGoals(view, kHere, {}, 5).empty());
  view.touches.clear();
  EXPECT_FALSE(rankGoals(view, kHere, {}, 5).empty());
}

TEST(Goals, LeadThroughTheDoorBetweenTouches) {
  ExplorationView view = knownSquare(0.9);
  // Closed, but for a door of 1 m on the right.
  touchAlong(view, {-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0});
  touchAlong(view, {-1.0, 1.0}, {1.0, 1.0}, {0.0, -1.0});
  touchAlong(view, {-1.0, -1.0}, {-1.0, 1.0}, {1.0, 0.0});
  view.way = {{0.0, 0.0}, {0.8, 0.0}, {1.0, 0.0}, {1.2, 0.0}};
  for (double x = 0.0; x < 1.2; x += 0.05) {
    view.way.push_back({x, 0.0});
  }
  touchAlong(view, {1.0, -1.0}, {1.0, -0.5}, {-1.0, 0.0});
  touchAlong(view, {1.0, 0.5}, {1.0, 1.0}, {-1.0, 0.0});
  const std::vector<ExplorationGoal> goals = rankGoals(view, kHere, {}, 1);
  ASSERT_EQ(goals.size(), 1u);
  EXPECT_GT(goals.front().position.x(), 1.0);
}

TEST(Goals, PreferTheSideWithoutAWall) {
  ExplorationView view = knownSquare(1.0);
  view.walls = {{{-1.2, -3.0}, {-1.2, 3.0}, 0.95, false}};
  const std::vector<ExplorationGoal> goals = rankGoals(view, kHere, {}, 1);
  ASSERT_EQ(goals.size(), 1u);
  EXPECT_GT(goals.front().position.x(), -1.2);
  EXPECT_GT(goals.front().arrival, 0.3);
}

TEST(Goals, CountNewRaysThroughDoubtfulWallsOnly) {
  ExplorationView view = knownSquare(1.0);
  view.access_points = {{0.0, 4.5}};
  const auto worth = [&](double confidence) {
    view.walls = {{{-4.0, 3.0}, {4.0, 3.0}, confidence, false}};
    double sum = 0.0;
    for (const ExplorationGoal& goal : rankGoals(view, kHere, {}, 5)) {
      sum += goal.walls_m2;
    }
    return sum;
  };
  EXPECT_GT(worth(0.5), 0.0);
  EXPECT_EQ(worth(0.999), 0.0);
}

TEST(Goals, KnowTheWayToAPlace) {
  const std::optional<ExplorationGoal> way = wayTo(knownSquare(2.0), kHere, {1.5, 0.5}, {});
  ASSERT_TRUE(way);
  EXPECT_LT((way->position - Position(1.5, 0.5)).norm(), 0.1);
  EXPECT_EQ(way->way.size(), 2u);  // nothing is in the way
}

TEST(Goals, KnowNoWayOutOfTouchedWalls) {
  ExplorationView view = knownSquare(0.9);
  touchAlong(view, {-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0});
  touchAlong(view, {-1.0, 1.0}, {1.0, 1.0}, {0.0, -1.0});
  touchAlong(view, {-1.0, -1.0}, {-1.0, 1.0}, {1.0, 0.0});
  touchAlong(view, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 0.0});
  EXPECT_FALSE(wayTo(view, kHere, {3.0, 0.0}, {}));
}

TEST(Touches, AreThoseOfThePoseNearestInTime) {
  const std::vector<PathPose> path{{1000, {0.0, 0.0}}, {2000, {1.0, 0.0}}, {3000, {2.0, 0.0}}};
  const std::vector<Contact> contacts{{2100, {1.15, 0.0}}, {3000, {2.0, 0.0}}};
  const std::vector<Touch> touches = touchesOf(contacts, path);
  ASSERT_EQ(touches.size(), 1u);
  EXPECT_EQ(touches.front().robot, Position(1.0, 0.0));
  EXPECT_EQ(touches.front().point, Position(1.15, 0.0));
  EXPECT_TRUE(touchesOf(contacts, {}).empty());
}

TEST(Goals, RefuseSettingsOutOfRange) {
  ExplorationConfig config;
  config.speed_m_s = 0.0;
  config.robot_radius_m = 5.0;
  const std::string text = complaintOf([&] { rankGoals(knownSquare(1.0), kHere, config, 1); });
  EXPECT_NE(text.find("speed must lie in"), std::string::npos) << text;
  EXPECT_NE(text.find("robot_radius must lie in"), std::string::npos) << text;
}

}  // namespace
}  // namespace sfw::test
