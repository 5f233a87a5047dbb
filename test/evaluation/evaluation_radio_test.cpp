#include <gtest/gtest.h>

#include <map>

#include "support/evaluation_world.h"

namespace sfw {
namespace {

using test::at;

/// A free hall with a wall from y = 1 to 5 at x = 10. The access point and the path at its other
/// side lie on y = 3, so that one cell of the wall is observed.
RadioMetrics metricsOf(const std::map<int, float>& losses_on_the_ray) {
  const std::string open(20, '.');
  std::string walled = open;
  walled[10] = '#';
  const test::Rows hall{open, walled, walled, walled, walled, walled, open};
  EvaluationInput input = test::input(hall, hall, test::along(16, 18, 3));
  input.access_points = {at(1, 3)};
  input.wall_loss_db = Grid<float>(input.truth.geometry);
  for (const auto& [x, loss] : losses_on_the_ray) {
    (*input.wall_loss_db)[Cell{x, 3}] = loss;
  }
  return evaluate(input).map.radio.value();
}

TEST(EvaluateRadio, ALossWhereTheWallStandsIsPerfect) {
  const RadioMetrics metrics = metricsOf({{10, 2.0F}});
  EXPECT_EQ(metrics.auc, 1.0);
  EXPECT_EQ(metrics.wall_f1_two_cells, 1.0);
  EXPECT_EQ(metrics.wall_f1_four_cells, 1.0);
}

TEST(EvaluateRadio, ALossBesideTheWallCountsWithinTheTolerance) {
  const RadioMetrics metrics = metricsOf({{13, 2.0F}});
  EXPECT_EQ(metrics.wall_f1_two_cells, 0.0);
  EXPECT_EQ(metrics.wall_f1_four_cells, 1.0);
}

TEST(EvaluateRadio, ASmallLossIsNoWall) {
  EXPECT_EQ(metricsOf({{10, 0.4F}}).wall_f1_four_cells, 0.0);
}

TEST(EvaluateRadio, OnlyTheRidgeOfALossIsAWall) {
  EXPECT_EQ(metricsOf({{10, 2.0F}, {14, 0.9F}}).wall_f1_two_cells, 1.0);
  // Farther away it is a ridge of its own: precision 1/2, recall 1.
  EXPECT_DOUBLE_EQ(metricsOf({{10, 2.0F}, {15, 0.9F}}).wall_f1_two_cells.value(), 2.0 / 3.0);
}

}  // namespace
}  // namespace sfw
