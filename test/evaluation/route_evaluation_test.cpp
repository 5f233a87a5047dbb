#include "evaluation/route_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/cheapest_ways.h"
#include "grid/for_each_cell.h"
#include "support/two_rooms.h"

namespace sfw {
namespace {

using test::twoRooms;

constexpr std::int64_t kNoWall = 0;
constexpr std::int64_t kClosed = 20;

/// From one room to the other, at two heights: far below the door, and just below it.
RouteMetrics metricsOf(const Grid<CellState>& map, std::int64_t y = 4) {
  return RouteEvaluation(twoRooms(), {{{4, y}, {28, y}}}).metricsOf(map);
}

TEST(RouteEvaluation, OnTheTruthEveryRouteIsShort) {
  const RouteMetrics metrics = metricsOf(twoRooms());
  EXPECT_EQ(metrics.reached, 1.0);
  EXPECT_EQ(metrics.through_walls, 0.0);
  EXPECT_EQ(metrics.no_plan, 0.0);
  EXPECT_EQ(metrics.detour_median, 1.0);
  EXPECT_EQ(metrics.detours_over_1m, 0.0);
}

TEST(RouteEvaluation, WithoutTheWallPlansCrossIt) {
  const RouteMetrics metrics = metricsOf(twoRooms(kNoWall));
  EXPECT_EQ(metrics.through_walls, 1.0);
  EXPECT_EQ(metrics.reached, 0.0);
  EXPECT_FALSE(metrics.detour_median);
  EXPECT_FALSE(metrics.detours_over_1m);
}

TEST(RouteEvaluation, ToScratchTheEndOfAWallIsNoCrossing) {
  // At row 10, the way around the end of the wall is 6.8 cells: less than 2 cells and 1 m.
  EXPECT_EQ(metricsOf(twoRooms(kNoWall), 10).reached, 1.0);
}

TEST(RouteEvaluation, AClosedDoorLeavesNoPlan) {
  EXPECT_EQ(metricsOf(twoRooms(kClosed)).no_plan, 1.0);
}

TEST(RouteEvaluation, AnUnknownGoalIsMovedByHalfAMetreAtMost) {
  const auto with_unknown = [](std::int64_t from_x) {
    Grid<CellState> map = twoRooms();
    forEachCell({from_x, 1}, {31, 20}, [&](Cell c) { map[c] = CellState::kUnknown; });
    return map;
  };
  EXPECT_EQ(metricsOf(with_unknown(24)).reached, 1.0);  // (23, 4) is 5 cells from the goal
  EXPECT_EQ(metricsOf(with_unknown(23)).no_plan, 1.0);
}

TEST(RouteEvaluation, AnEmptyMapHasNoPlans) {
  const Grid<CellState> unknown(twoRooms().geometry, CellState::kUnknown);
  EXPECT_EQ(metricsOf(unknown).no_plan, 1.0);
}

TEST(RouteEvaluation, SharesCountEachRoute) {
  const RouteEvaluation routes(twoRooms(), {{{4, 4}, {28, 4}},    // through the wall
                                            {{4, 4}, {4, 17}},    // within a room
                                            {{4, 17}, {28, 17}},  // through the door
                                            {{4, 17}, {28, 4}}});
  const RouteMetrics metrics = routes.metricsOf(twoRooms(kNoWall));
  EXPECT_GE(metrics.through_walls, 0.25);
  EXPECT_GE(metrics.reached, 0.5);
  EXPECT_DOUBLE_EQ(metrics.through_walls + metrics.reached + metrics.no_plan, 1.0);
}

TEST(RouteEvaluation, AWallThatIsNotThereMakesADetour) {
  const Grid<CellState> hall(GridGeometry(0.1, Position::Zero(), 60, 40), CellState::kFree);
  Grid<CellState> map = hall;
  forEachCell({30, 0}, {30, 29}, [&](Cell c) { map[c] = CellState::kOccupied; });
  const RouteMetrics metrics = RouteEvaluation(hall, {{{20, 4}, {40, 4}}}).metricsOf(map);
  // 20 cells straight; around (30, 30), at least two diagonals of 10 x 26 cells.
  EXPECT_GE(metrics.detour_median.value(), 2.0 * std::hypot(10.0, 26.0) / 20.0);
  EXPECT_LE(metrics.detour_median.value(), 2.0 * (10.0 + 30.0) / 20.0);
  EXPECT_EQ(metrics.detours_over_1m, 1.0);
}

TEST(DrawRoutes, LeadToRoomsBehindDoors) {
  const Grid<CellState> truth = twoRooms();
  const std::vector<RouteEnds> routes = drawRoutes(truth, {{0.8, 1.0}}, 50);
  ASSERT_GT(routes.size(), 100U);
  bool into_other_room = false;
  for (const RouteEnds& route : routes) {
    EXPECT_GE((truth.geometry.centre(route.from) - truth.geometry.centre(route.to)).norm(),
              2.0 - 1e-9);
    EXPECT_LT((truth.geometry.centre(route.from) - Position(0.8, 1.0)).norm(), 2.1);
    EXPECT_LT((truth.geometry.centre(route.to) - Position(0.8, 1.0)).norm(), 2.1);
    into_other_room |= (route.from.x < 16) != (route.to.x < 16);
  }
  EXPECT_TRUE(into_other_room);
  EXPECT_EQ(drawRoutes(truth, {{0.8, 1.0}}, 50).front().to, routes.front().to);
}

TEST(DrawRoutes, AreNoneWithoutRoomForThem) {
  EXPECT_TRUE(drawRoutes(twoRooms(), {{50.0, 50.0}}, 50).empty());
  EXPECT_TRUE(drawRoutes(twoRooms(), {}, 50).empty());
  EXPECT_TRUE(drawRoutes(Grid<CellState>(twoRooms().geometry), {{0.8, 1.0}}, 50).empty());
  const Grid<CellState> closet(GridGeometry(0.1, Position::Zero(), 12, 12), CellState::kFree);
  EXPECT_TRUE(drawRoutes(closet, {{0.6, 0.6}}, 50).empty());
}

TEST(CheapestWays, StepsCostTheMeanOfBothCells) {
  Grid<double> costs(GridGeometry(1.0, Position::Zero(), 3, 2), 1.0);
  costs[{1, 0}] = costs[{1, 1}] = 5.0;
  CheapestWays ways(costs);
  ways.search({0, 0}, {{2, 0}, {0, 1}});
  EXPECT_DOUBLE_EQ(ways.costTo({2, 0}).value(), 6.0);
  EXPECT_DOUBLE_EQ(ways.costTo({0, 1}).value(), 1.0);
  EXPECT_EQ(ways.to({2, 0}), (std::vector<Cell>{{0, 0}, {1, 0}, {2, 0}}));
}

TEST(CheapestWays, GoAroundWhatCannotBeEntered) {
  Grid<double> costs(GridGeometry(1.0, Position::Zero(), 3, 3), 1.0);
  costs[{1, 0}] = 0.0;
  costs[{1, 1}] = -1.0;
  CheapestWays ways(costs);
  ways.search({0, 0}, {{2, 0}});
  EXPECT_DOUBLE_EQ(ways.costTo({2, 0}).value(), 2.0 + 2.0 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(lengthOf(ways.to({2, 0})), 2.0 + 2.0 * std::sqrt(2.0));
}

TEST(CheapestWays, ForgetTheLastSearch) {
  Grid<double> costs(GridGeometry(1.0, Position::Zero(), 3, 1), 1.0);
  CheapestWays ways(costs);
  ways.search({0, 0}, {{2, 0}});
  costs[{1, 0}] = 0.0;
  ways.search({0, 0}, {{2, 0}});
  EXPECT_FALSE(ways.costTo({2, 0}));
  EXPECT_TRUE(ways.to({2, 0}).empty());
  ways.search({1, 0}, {{0, 0}});  // it cannot start
  EXPECT_FALSE(ways.costTo({0, 0}));
}

}  // namespace
}  // namespace sfw
