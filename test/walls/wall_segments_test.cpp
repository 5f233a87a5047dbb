#include "walls/wall_segments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sfw {
namespace {

/// Cells of 0.1 m; cell (0, 0) begins at (-1, 2).
const GridGeometry kGeometry(0.1, {-1.0, 2.0}, 40, 40);

/// A wall along y: its column in each row from `first_row` on, with the cells of sideways steps.
StripWall wallAlongY(const std::vector<std::int64_t>& columns, std::int64_t first_row = 0) {
  StripWall wall{{}, 0.9};
  std::int64_t last = columns.front();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::int64_t row = first_row + static_cast<std::int64_t>(i);
    const std::int64_t step = columns[i] < last ? -1 : 1;
    for (std::int64_t column = last; column != columns[i] + step; column += step) {
      wall.cells.push_back({column, row});
    }
    last = columns[i];
  }
  return wall;
}

void expectSegment(const WallSegment& segment, const Position& from, const Position& to) {
  EXPECT_NEAR((segment.from - from).norm(), 0.0, 1e-9) << segment.from.transpose();
  EXPECT_NEAR((segment.to - to).norm(), 0.0, 1e-9) << segment.to.transpose();
}

TEST(WallSegments, AStraightWallIsOneSegmentFromEdgeToEdge) {
  const auto segments = straightPieces(wallAlongY({4, 4, 4, 4, 4, 4}, 10), kGeometry);
  ASSERT_EQ(segments.size(), 1U);
  expectSegment(segments[0], {-0.55, 3.0}, {-0.55, 3.6});
}

TEST(WallSegments, TurnWithTheWall) {
  StripWall wall = wallAlongY({4, 4, 4, 8, 8, 8, 8}, 10);
  const auto along_y = straightPieces(wall, kGeometry);
  for (Cell& c : wall.cells) {
    std::swap(c.x, c.y);
  }
  const GridGeometry turned(0.1, {2.0, -1.0}, 40, 40);
  const auto along_x = straightPieces(wall, turned);
  ASSERT_EQ(along_x.size(), along_y.size());
  for (std::size_t i = 0; i < along_x.size(); ++i) {
    expectSegment(along_x[i], {along_y[i].from.y(), along_y[i].from.x()},
                  {along_y[i].to.y(), along_y[i].to.x()});
  }
}

TEST(WallSegments, SmallStepsStayInOnePieceAtTheMedianPlace) {
  const auto segments = straightPieces(wallAlongY({4, 5, 5, 6, 5, 5, 4, 6}), kGeometry);
  ASSERT_EQ(segments.size(), 1U);
  expectSegment(segments[0], {-0.45, 2.0}, {-0.45, 2.8});
}

TEST(WallSegments, ALargeStepStartsANewPieceBesideTheLastOne) {
  const auto segments = straightPieces(wallAlongY({4, 4, 4, 4, 7, 7, 7, 7}), kGeometry);
  ASSERT_EQ(segments.size(), 2U);
  expectSegment(segments[0], {-0.55, 2.0}, {-0.55, 2.5});  // the step lies in the fifth row
  expectSegment(segments[1], {-0.25, 2.4}, {-0.25, 2.8});
}

TEST(WallSegments, ACornerStartsAPieceAlongTheOtherAxis) {
  const auto segments = straightPieces(wallAlongY({4, 4, 4, 4, 4, 12, 12}), kGeometry);
  ASSERT_EQ(segments.size(), 2U);
  expectSegment(segments[0], {-0.55, 2.0}, {-0.55, 2.6});
  expectSegment(segments[1], {-0.3, 2.55}, {0.3, 2.55});
}

TEST(WallSegments, ASlantedWallBecomesStairs) {
  const auto segments = straightPieces(wallAlongY({4, 5, 6, 7, 8, 9, 10, 11, 12}), kGeometry);
  EXPECT_GT(segments.size(), 1U);
  for (std::size_t i = 1; i < segments.size(); ++i) {  // without gaps
    const Position last = 0.5 * (segments[i - 1].from + segments[i - 1].to);
    const Position next = 0.5 * (segments[i].from + segments[i].to);
    EXPECT_LT((next - last).norm(), 0.5);
    EXPECT_GT(next.x(), last.x());
    EXPECT_GT(next.y(), last.y());
  }
}

TEST(WallSegments, ADoorBetweenTwoPartsLeavesTwoSegments) {
  StripWall wall = wallAlongY({4, 4, 4, 4, 4, 4, 4, 4, 4, 4});
  wall.cells.erase(wall.cells.begin() + 3, wall.cells.begin() + 6);
  const auto segments = straightPieces(wall, kGeometry);
  ASSERT_EQ(segments.size(), 2U);
  expectSegment(segments[0], {-0.55, 2.0}, {-0.55, 2.3});
  expectSegment(segments[1], {-0.55, 2.6}, {-0.55, 3.0});
}

TEST(WallSegments, TheOrderOfCellsDoesNotTurnASegment) {
  StripWall wall = wallAlongY({4, 4, 4, 4, 4});
  std::reverse(wall.cells.begin(), wall.cells.end());
  const auto segments = straightPieces(wall, kGeometry);
  ASSERT_EQ(segments.size(), 1U);
  expectSegment(segments[0], {-0.55, 2.0}, {-0.55, 2.5});
}

TEST(WallSegments, ConfidenceIsTheProbabilityOfAtLeastOneWall) {
  StripWall wall = wallAlongY({4, 4, 4, 4, 7, 7, 7, 7});
  for (const double expected : {0.1, 0.9, 3.0}) {
    wall.expected = expected;
    for (const WallSegment& segment : straightPieces(wall, kGeometry)) {
      EXPECT_NEAR(segment.confidence, 1.0 - std::exp(-expected), 1e-12);
    }
  }
}

TEST(WallSegments, PiecesOfAnOuterWallAreOuter) {
  StripWall wall = wallAlongY({4, 4, 4, 8, 8, 8});
  for (const bool is_outer : {false, true}) {
    wall.is_outer = is_outer;
    const auto segments = straightPieces(wall, kGeometry);
    ASSERT_GT(segments.size(), 1U);
    for (const WallSegment& segment : segments) {
      EXPECT_EQ(segment.is_outer, is_outer);
    }
  }
}

TEST(WallSegments, OneCellHasTheLengthOfACellAndNoCellHasNoSegment) {
  const auto segments = straightPieces({{{3, 5}}, 0.9}, kGeometry);
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_NEAR((segments[0].to - segments[0].from).norm(), 0.1, 1e-9);
  EXPECT_TRUE(straightPieces({}, kGeometry).empty());
}

}  // namespace
}  // namespace sfw
