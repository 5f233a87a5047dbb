#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "evaluation/evaluation.h"
#include "structure_from_wifi/input_error.h"
#include "support/evaluation_world.h"

namespace sfw {
namespace {

using test::along;
using test::at;
using test::input;
using test::kMap;
using test::kRooms;
using test::rooms;
using test::Rows;

TEST(EvaluateDegenerate, AnUnknownMapFindsNothing) {
  const Evaluation evaluation =
      evaluate(input(Rows(7, std::string(12, '?')), kRooms, along(1, 5, 3)));
  EXPECT_EQ(evaluation.map.free.precision, 0.0);
  EXPECT_EQ(evaluation.map.free.recall, 0.0);
  EXPECT_EQ(evaluation.map.free.iou, 0.0);
  EXPECT_EQ(evaluation.map.wall_two_cells->precision, 0.0);
  EXPECT_EQ(evaluation.map.wall_two_cells->recall, 0.0);
  EXPECT_EQ(evaluation.map.wall_two_cells->f1, 0.0);
  EXPECT_EQ(evaluation.map.wall_in_free, 0.0);
  EXPECT_EQ(evaluation.map.walls_called_free, 0.0);
}

TEST(EvaluateDegenerate, AMapFarAwayFindsNothing) {
  EvaluationInput remote = rooms();
  remote.map = Grid<CellState>(GridGeometry(1e-9, {1e300, -1e300}, 2, 2), CellState::kFree);
  EXPECT_EQ(evaluate(remote).map.free.recall, 0.0);
}

TEST(EvaluateDegenerate, WithoutWallsInTheTruthTheirRecallHasNoMeaning) {
  EvaluationInput open = input({"..#"}, {"..."}, {at(0, 0)});
  open.access_points = {at(2, 0)};
  const Evaluation evaluation = evaluate(open);
  EXPECT_EQ(evaluation.wall_cells, 0U);
  EXPECT_EQ(evaluation.map.wall_one_cell->precision, 0.0);
  EXPECT_FALSE(evaluation.map.wall_one_cell->recall);
  EXPECT_FALSE(evaluation.map.wall_one_cell->f1);
  EXPECT_FALSE(evaluation.map.wall_one_cell->observed_recall);
  EXPECT_EQ(evaluation.map.wall_in_free, 1.0);
  EXPECT_FALSE(evaluation.map.walls_called_free);
  EXPECT_FALSE(evaluation.map.observed_walls_called_free);
}

TEST(EvaluateDegenerate, PositionsOffTheTruthDecideNothing) {
  EvaluationInput outside = rooms();
  for (int i = 0; i < 20; ++i) {
    outside.path.push_back(at(100.0 + i, 3));
  }
  EXPECT_NEAR(evaluate(outside).free_m2, 25 * 0.0025, 1e-12);
}

TEST(EvaluateRefuses, APathThatNeverTouchesFreeSpace) {
  EXPECT_THROW(evaluate(input(kMap, kRooms, {at(0, 0), at(6, 3)})), InputError);
  EXPECT_THROW(evaluate(input(kMap, kRooms, {at(500, 500)})), InputError);
  EXPECT_THROW(evaluate(input({"?"}, {"?"}, {at(0, 0)})), InputError);
}

TEST(EvaluateRefuses, NonsensePositions) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(evaluate(input(kMap, kRooms, {})), std::invalid_argument);
  EXPECT_THROW(evaluate(input(kMap, kRooms, {Position(kNan, 0.0)})), std::invalid_argument);
  EXPECT_THROW(evaluate(input(kMap, kRooms, {Position(0.0, 1e300)})), std::invalid_argument);
  EvaluationInput lost = rooms();
  lost.access_points = {Position(0.0, kNan)};
  EXPECT_THROW(evaluate(lost), std::invalid_argument);
}

TEST(EvaluateRefuses, ATruthOfNoCellOrTooMany) {
  EvaluationInput sized = rooms();
  sized.truth = Grid<CellState>(GridGeometry(0.01, {0.0, 0.0}, 4, 4), CellState::kFree);
  EXPECT_THROW(evaluate(sized), InputError);
  sized.truth = Grid<CellState>(GridGeometry(1.0, {0.0, 0.0}, 401, 400), CellState::kFree);
  EXPECT_THROW(evaluate(sized), InputError);
  sized.truth = Grid<CellState>(GridGeometry(1e300, {0.0, 0.0}, 4, 4), CellState::kFree);
  EXPECT_THROW(evaluate(sized), InputError);
  sized.truth = Grid<CellState>(GridGeometry(0.05, {1e300, 0.0}, 4, 4), CellState::kFree);
  EXPECT_THROW(evaluate(sized), std::invalid_argument);
}

}  // namespace
}  // namespace sfw
