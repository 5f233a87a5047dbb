#include "evaluation/navigation_evaluation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "evaluation/evaluation.h"
#include "support/two_rooms.h"

namespace sfw {
namespace {

using test::twoRooms;

/// A drive along the wall in one room, and along it in the other.
std::vector<Position> drive() {
  std::vector<Position> path;
  for (double y = 0.35; y < 1.9; y += 0.2) {
    path.emplace_back(1.05, y);
    path.emplace_back(2.25, y);
  }
  return path;
}

EvaluationInput rooms(const Grid<CellState>& map) {
  EvaluationInput input{map, twoRooms(), drive(), {}, std::nullopt};
  input.navigation = std::make_shared<const NavigationEvaluation>(input.truth, input.path);
  return input;
}

TEST(NavigationEvaluation, IsPartOfTheEvaluation) {
  const Evaluation evaluation = evaluate(rooms(twoRooms()));
  EXPECT_EQ(evaluation.map.navigation.walls.value().f1, 1.0);
  EXPECT_EQ(evaluation.map.navigation.routes.value().reached, 1.0);
  // The path alone closes the gap between both drives, over the wall.
  EXPECT_LT(evaluation.path_only.navigation.walls.value().f1.value(), 1.0);
  EXPECT_FALSE(evaluation.path_only.navigation.walls->auc);
}

TEST(NavigationEvaluation, IsLeftOutUnlessGiven) {
  EvaluationInput input = rooms(twoRooms());
  input.navigation.reset();
  EXPECT_FALSE(evaluate(input).map.navigation.walls);
  EXPECT_FALSE(evaluate(input).map.navigation.routes);
}

TEST(NavigationEvaluation, OfOnePlaceHasNoMetrics) {
  const NavigationEvaluation one(twoRooms(), {{50.0, 50.0}});
  EXPECT_FALSE(one.metricsOf(twoRooms(), std::nullopt).walls);
  EXPECT_FALSE(one.metricsOf(twoRooms(), std::nullopt).routes);
}

TEST(NavigationEvaluation, RefusesNonsensePositions) {
  EXPECT_THROW(NavigationEvaluation(twoRooms(), {{0.0, 1e300}}), std::invalid_argument);
  EXPECT_THROW(NavigationEvaluation(twoRooms(), {{std::nan(""), 1.0}}), std::invalid_argument);
}

TEST(NavigationEvaluation, GapsOfThePathDoNotMatter) {
  // Places 1 m apart, as in a survey.
  const std::vector<Position> survey{{0.55, 0.55}, {0.55, 1.55}, {2.65, 0.55}, {2.65, 1.55}};
  const NavigationMetrics metrics =
      NavigationEvaluation(twoRooms(), survey).metricsOf(twoRooms(), std::nullopt);
  EXPECT_EQ(metrics.walls.value().f1, 1.0);
  EXPECT_EQ(metrics.routes.value().reached, 1.0);
}

}  // namespace
}  // namespace sfw
