#include "evaluation/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
using test::world;

TEST(Evaluate, FreeCellsAgainstTheRegion) {
  const Evaluation evaluation = evaluate(rooms());
  EXPECT_NEAR(evaluation.free_m2, 25 * 0.0025, 1e-12);
  const FreeMetrics& free = evaluation.map.free;
  EXPECT_DOUBLE_EQ(free.precision, 20.0 / 30.0);
  EXPECT_DOUBLE_EQ(free.tolerant_precision, 1.0);  // the wrong ones are 1 and 2 cells off
  EXPECT_DOUBLE_EQ(free.recall, 20.0 / 25.0);
  EXPECT_DOUBLE_EQ(free.iou, 20.0 / 35.0);
  EXPECT_EQ(free.beyond_m2, 0.0);  // nothing is farther than two cells from the path
  EXPECT_EQ(free.beyond_precision, 0.0);
}

TEST(Evaluate, WallsWithinOneCell) {
  const Evaluation evaluation = evaluate(rooms());
  EXPECT_EQ(evaluation.wall_cells, 24U);
  const WallMetrics walls = evaluation.map.wall_one_cell.value();
  EXPECT_DOUBLE_EQ(walls.precision, 7.0 / 10.0);  // x = 0, and the ends of x = 8 next to the frame
  EXPECT_DOUBLE_EQ(walls.recall.value(), 7.0 / 24.0);  // x = 0 with its corners
  EXPECT_NEAR(walls.f1.value(), 2 * 0.7 * (7.0 / 24) / (0.7 + 7.0 / 24), 1e-12);
}

TEST(Evaluate, WallsWithinTwoCells) {
  const WallMetrics walls = evaluate(rooms()).map.wall_two_cells.value();
  EXPECT_DOUBLE_EQ(walls.precision, 1.0);
  // Besides x = 0 with corners, the frame's cells beside them at x = 1, and x = 6 but its corners.
  EXPECT_DOUBLE_EQ(walls.recall.value(), 14.0 / 24.0);
  EXPECT_DOUBLE_EQ(walls.f1.value(), 14.0 / 19.0);
}

TEST(Evaluate, ObservedWallsAreThoseOnRays) {
  EvaluationInput observed = rooms();
  observed.access_points = {at(9, 3)};  // every ray runs in row 3 and crosses (6, 3) alone
  const Evaluation evaluation = evaluate(observed);
  EXPECT_EQ(evaluation.observed_wall_cells, 1U);
  EXPECT_EQ(evaluation.map.wall_one_cell->observed_recall, 0.0);
  EXPECT_EQ(evaluation.map.wall_two_cells->observed_recall, 1.0);
  EXPECT_EQ(evaluation.map.observed_walls_called_free, 1.0);
  EXPECT_DOUBLE_EQ(evaluation.map.walls_called_free.value(), 5.0 / 24.0);  // x = 6
}

TEST(Evaluate, WithoutAccessPointsNothingIsObserved) {
  const Evaluation evaluation = evaluate(rooms());
  EXPECT_FALSE(evaluation.observed_wall_cells);
  EXPECT_FALSE(evaluation.map.observed_walls_called_free);
  EXPECT_FALSE(evaluation.map.wall_one_cell->observed_recall);
}

TEST(Evaluate, AnAccessPointBeyondHearingIsLeftOut) {
  EvaluationInput remote = rooms();
  remote.access_points = {Position(1e6, -1e6)};
  EXPECT_EQ(evaluate(remote).observed_wall_cells, 0U);
}

TEST(Evaluate, WallsInTheMiddleOfTheRoom) {
  // (3, 3) is three cells from the frame, (4, 3) two.
  const Evaluation evaluation = evaluate(input({"????????????",  //
                                                "????????????",  //
                                                "????????????",  //
                                                "???##???????",  //
                                                "????????????",  //
                                                "????????????",  //
                                                "????????????"},
                                               kRooms, along(1, 5, 3)));
  EXPECT_EQ(evaluation.map.wall_in_free, 0.5);
}

TEST(Evaluate, PathOnlyIsThePathGrown) {
  // A straight line closes to itself; 0.15 m are two cells to all sides: x = 0..7, y = 1..5.
  const Evaluation evaluation = evaluate(rooms());
  EXPECT_DOUBLE_EQ(evaluation.path_only.free.precision, 25.0 / 40.0);
  EXPECT_DOUBLE_EQ(evaluation.path_only.free.recall, 1.0);
  EXPECT_DOUBLE_EQ(evaluation.path_only.walls_called_free.value(), 10.0 / 24.0);  // x = 0 and x = 6
  EXPECT_FALSE(evaluation.path_only.wall_one_cell);
  EXPECT_FALSE(evaluation.path_only.wall_in_free);
  EXPECT_FALSE(evaluation.path_only.probability);
}

TEST(Evaluate, PathOnlyMapIsTheOneScored) {
  EvaluationInput judged = rooms();
  const Evaluation evaluation = evaluate(judged);
  judged.map = pathOnlyMap(judged);
  const MapMetrics metrics = evaluate(judged).map;
  EXPECT_EQ(metrics.free.precision, evaluation.path_only.free.precision);
  EXPECT_EQ(metrics.free.iou, evaluation.path_only.free.iou);
  EXPECT_EQ(metrics.walls_called_free, evaluation.path_only.walls_called_free);
}

TEST(Evaluate, PathOnlyFillsALoop) {
  const Rows open(40, std::string(40, '.'));
  std::vector<Position> loop = {at(5, 5),   at(20, 5), at(34, 5), at(34, 20), at(34, 34),
                                at(20, 34), at(5, 34), at(5, 20), at(5, 5)};
  // Closed, it is the square of 30 x 30 cells; grown, 34 x 34 with whole corners.
  EXPECT_DOUBLE_EQ(evaluate(input(open, open, loop)).path_only.free.recall, 34.0 * 34.0 / 1600.0);
}

TEST(Evaluate, PositionsAMetreApartAreNotJoined) {
  const Rows open = {std::string(40, '.')};
  const auto recall = [&](double to_x) {
    return evaluate(input(open, open, {at(0, 0), at(to_x, 0)})).path_only.free.recall;
  };
  EXPECT_DOUBLE_EQ(recall(25), (3.0 + 5.0) / 40.0);  // x = 0..2 and 23..27
  EXPECT_DOUBLE_EQ(recall(19), 22.0 / 40.0);         // x = 0..21
}

TEST(Evaluate, BeyondStartsThirtyCentimetresFromThePath) {
  // The path is the cell (0, 1); from x = 6 on, all is farther away than 0.3 m.
  const Rows open(3, std::string(20, '.'));
  const Rows truth(3, std::string(18, '.') + "??");
  const FreeMetrics free = evaluate(input(open, truth, {at(0, 1)})).map.free;
  EXPECT_NEAR(free.beyond_m2, 12 * 3 * 0.0025, 1e-12);
  EXPECT_DOUBLE_EQ(free.beyond_precision, 12.0 / 14.0);
}

TEST(Evaluate, UnknownTruthCountsOnlyWhereThereIsMuchOfIt) {
  const Rows open(3, std::string(20, '.'));
  const auto precision = [&](const std::string& row) {
    return evaluate(input(open, Rows(3, row), {at(0, 1)})).map.free.precision;
  };
  EXPECT_DOUBLE_EQ(precision("..................??"), 18.0 / 20.0);  // 90 % known
  EXPECT_DOUBLE_EQ(precision("...................?"), 1.0);          // 95 %
}

TEST(Evaluate, RegionIsWhereMostPositionsLieAndRepeatsCountOnce) {
  std::vector<Position> path(10, at(2, 3));  // the left room, again and again
  path.push_back(at(8, 2));
  path.push_back(at(9, 2));
  const Evaluation evaluation = evaluate(input(kMap, kRooms, path));
  EXPECT_NEAR(evaluation.free_m2, 20 * 0.0025, 1e-12);
}

TEST(Evaluate, AMapThatEqualsTheTruthIsPerfectAtAnyResolution) {
  const Rows coarse = {"####", "#..#", "####"};
  EvaluationInput same{
      world({"########", "########", "##....##", "##....##", "########", "########"}),
      world(coarse, 0.1),
      {at(3, 3)},
      {},
      std::nullopt};
  const Evaluation evaluation = evaluate(same);
  EXPECT_NEAR(evaluation.free_m2, 0.02, 1e-12);
  EXPECT_EQ(evaluation.map.free.iou, 1.0);
  EXPECT_EQ(evaluation.map.wall_one_cell->f1, 1.0);
  EXPECT_EQ(evaluation.map.walls_called_free, 0.0);
}

TEST(Evaluate, MirroredInputHasTheSameMetrics) {
  EvaluationInput plain = rooms();
  plain.access_points = {at(9, 1)};
  EvaluationInput mirrored = plain;
  for (Grid<CellState>* grid : {&mirrored.map, &mirrored.truth}) {
    for (auto row = grid->cells.begin(); row != grid->cells.end(); row += 12) {
      std::reverse(row, row + 12);
    }
  }
  for (std::vector<Position>* positions : {&mirrored.path, &mirrored.access_points}) {
    for (Position& position : *positions) {
      position.x() = 12 * 0.05 - position.x();
    }
  }
  const Evaluation a = evaluate(plain);
  const Evaluation b = evaluate(mirrored);
  EXPECT_EQ(a.map.free.iou, b.map.free.iou);
  EXPECT_EQ(a.map.wall_two_cells->f1, b.map.wall_two_cells->f1);
  EXPECT_EQ(a.observed_wall_cells, b.observed_wall_cells);
  EXPECT_EQ(a.map.observed_walls_called_free, b.map.observed_walls_called_free);
  EXPECT_EQ(a.path_only.free.iou, b.path_only.free.iou);
}

Grid<float> probabilities(const std::vector<float>& row) {
  Grid<float> grid(GridGeometry(0.05, {0.0, 0.0}, static_cast<std::int64_t>(row.size()), 1));
  grid.cells = row;
  return grid;
}

TEST(EvaluateProbabilities, CompareCellsThatTheMapKnows) {
  EvaluationInput rated = input({"?..#"}, {"...#"}, {at(0, 0)});
  rated.probabilities = probabilities({0.9F, 0.1F, 0.4F, 0.4F});
  const ProbabilityMetrics metrics = evaluate(rated).map.probability.value();
  EXPECT_EQ(metrics.cells, 3U);
  EXPECT_DOUBLE_EQ(metrics.auc.value(), 0.75);  // one pair is right, one is a tie
  EXPECT_NEAR(metrics.brier.value(), (0.01 + 0.16 + 0.36) / 3, 1e-7);
  EXPECT_NEAR(metrics.log_loss.value(), -(std::log(0.9) + std::log(0.6) + std::log(0.4)) / 3, 1e-7);
}

TEST(EvaluateProbabilities, BeingCertainAndWrongCostsABoundedLoss) {
  EvaluationInput rated = input({".#"}, {".#"}, {at(0, 0)});
  rated.probabilities = probabilities({1.0F, 0.0F});
  const ProbabilityMetrics metrics = evaluate(rated).map.probability.value();
  EXPECT_EQ(metrics.auc, 0.0);
  EXPECT_EQ(metrics.brier, 1.0);
  EXPECT_NEAR(metrics.log_loss.value(), std::log(510.0), 1e-9);
}

TEST(EvaluateProbabilities, OutsideTheUnitIntervalCountAsUndecided) {
  EvaluationInput rated = input({".#"}, {".#"}, {at(0, 0)});
  rated.probabilities = probabilities({std::numeric_limits<float>::quiet_NaN(), 7.0F});
  EXPECT_DOUBLE_EQ(evaluate(rated).map.probability->brier.value(), 0.25);
}

TEST(EvaluateProbabilities, OfAnUnknownMapHaveNoMetrics) {
  EvaluationInput rated = input({"??"}, {".#"}, {at(0, 0)});
  rated.probabilities = probabilities({0.1F, 0.9F});
  const ProbabilityMetrics metrics = evaluate(rated).map.probability.value();
  EXPECT_EQ(metrics.cells, 0U);
  EXPECT_FALSE(metrics.auc);
  EXPECT_FALSE(metrics.brier);
  EXPECT_FALSE(metrics.log_loss);
}

}  // namespace
}  // namespace sfw
