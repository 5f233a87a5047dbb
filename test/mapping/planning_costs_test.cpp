#include "structure_from_wifi/planning_costs.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grid/robot_evidence.h"
#include "support/ascii_world.h"

namespace sfw {
namespace {

constexpr double kFootprintRadius = 0.05;  // [m]; risks count within 0.2 m: two cells

/// A map that is free everywhere, with a risk of 2 % in all cells but one.
class PlanningCosts : public testing::Test {
 protected:
  PlanningCosts() : free_(kGeometry, 0.02F), probability_(kGeometry, 0.02F) {}

  Grid<std::int8_t> costs() const {
    return planningCosts({BeliefMap(free_, {}), BeliefMap(probability_, {}), {}, {}, {}},
                         kFootprintRadius);
  }

  /// The costs of the cells in the row of the risky cell, from it on.
  std::vector<int> costsBeside(float probability) {
    probability_[kRisky] = probability;
    const Grid<std::int8_t> all = costs();
    std::vector<int> row;
    for (std::int64_t x = kRisky.x; x < kGeometry.width(); ++x) {
      row.push_back(all[{x, kRisky.y}]);
    }
    return row;
  }

  inline static const GridGeometry kGeometry{0.1, {-1.0, 2.0}, 7, 5};
  static constexpr Cell kRisky{2, 2};
  Grid<float> free_, probability_;
};

TEST_F(PlanningCosts, GrowWithTheRiskWithinReachOfTheRobot) {
  // The belief holds log odds in steps of 1/16, so a cost can be off by 2.
  const std::vector<int> row = costsBeside(0.15F);
  ASSERT_EQ(row.size(), 5U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(row[i], 60, 2) << i;  // 99 * 0.15 / 0.25
  }
  for (std::size_t i = 3; i < 5; ++i) {
    EXPECT_NEAR(row[i], 8, 1) << i;  // 99 * 0.02 / 0.25
  }
}

TEST_F(PlanningCosts, ReachInADisc) {
  probability_[kRisky] = 0.15F;
  const Grid<std::int8_t> all = costs();
  EXPECT_NEAR((all[{2, 4}]), 60, 2);
  EXPECT_NEAR((all[{3, 3}]), 60, 2);
  EXPECT_NEAR((all[{4, 4}]), 8, 1) << "its centre is 0.28 m away";
}

TEST_F(PlanningCosts, OfAFreeCellEndBelowThoseOfAWall) {
  EXPECT_EQ(costsBeside(0.26F).front(), kDearestCost);
  EXPECT_EQ(costsBeside(0.9F).front(), kDearestCost);
}

TEST_F(PlanningCosts, TellWallsAndUnknownCellsByTheMap) {
  free_[{5, 2}] = 0.9F;
  free_[{6, 2}] = kUnknownOccupancy;
  probability_[{6, 2}] = 0.9F;
  EXPECT_EQ((costs()[{5, 2}]), kOccupiedCost);
  EXPECT_EQ((costs()[{6, 2}]), kUnknownCost);
  EXPECT_EQ((costs()[{4, 2}]), kDearestCost) << "beside a likely wall that the map calls unknown";
}

TEST_F(PlanningCosts, LeaveOutCellsOfUnknownProbability) {
  EXPECT_NEAR(costsBeside(kUnknownOccupancy).front(), 8, 1);
}

TEST_F(PlanningCosts, AreUnknownInAFreshMap) {
  const BeliefMap nothing(kGeometry, {});
  const Grid<std::int8_t> costs = planningCosts({nothing, nothing, {}, {}, {}}, kFootprintRadius);
  EXPECT_EQ(costs.cells, std::vector<std::int8_t>(kGeometry.size(), kUnknownCost));
}

/// The rows of the costs of walls after a touch: '#' is 100.
std::vector<std::string> wallsAfterTouch(const Position& robot, const Position& contact) {
  const GridGeometry geometry(0.1, {0.0, 0.0}, 9, 6);
  const BeliefMap nothing(geometry, {});
  Snapshot snapshot{nothing, nothing, {{1000, robot}}, {}, {}};
  snapshot.contacts = {{1010, contact}};
  return test::rowsOf(planningCosts(snapshot, 0.15),
                      [](std::int8_t cost) { return cost == kOccupiedCost ? '#' : '.'; });
}

TEST(TouchedWalls, StandAcrossTheDirectionOfTheTouch) {
  EXPECT_EQ(wallsAfterTouch({0.45, 0.15}, {0.45, 0.35}),
            (std::vector<std::string>{".........",  //
                                      ".........",  //
                                      "..#####..",  //
                                      ".........",  //
                                      ".........",  //
                                      "........."}));
  EXPECT_EQ(wallsAfterTouch({0.25, 0.35}, {0.45, 0.35}),
            (std::vector<std::string>{"....#....",  //
                                      "....#....",  //
                                      "....#....",  //
                                      "....#....",  //
                                      "....#....",  //
                                      "........."}));
}

TEST(TouchedWalls, LeaveOutWhereTheRobotWas) {
  const GridGeometry geometry(0.1, {0.0, 0.0}, 9, 6);
  const BeliefMap nothing(geometry, {});
  // After the touch the robot passes on the right of it.
  Snapshot snapshot{nothing, nothing, {{1000, {0.45, 0.15}}, {2000, {0.65, 0.35}}}, {}, {}};
  snapshot.contacts = {{1010, {0.45, 0.35}}};
  const Grid<std::int8_t> costs = planningCosts(snapshot, 0.16);
  EXPECT_EQ((costs[{2, 3}]), kOccupiedCost);
  EXPECT_EQ((costs[{4, 3}]), kOccupiedCost);
  EXPECT_EQ((costs[{5, 3}]), kUnknownCost) << "it covered this cell";
}

TEST(TouchedWalls, AreNotKnownWithoutThePoseOfTheRobot) {
  for (const Position& robot : {Position(0.45, 0.35), Position(9.0, 0.35)}) {
    for (const std::string& row : wallsAfterTouch(robot, {0.45, 0.35})) {
      EXPECT_EQ(row, ".........");
    }
  }
}

}  // namespace
}  // namespace sfw
