#include "evaluation/wall_knowledge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grid/for_each_cell.h"
#include "support/two_rooms.h"

namespace sfw {
namespace {

using test::twoRooms;

constexpr std::size_t kMostPairs = 50000;
constexpr std::int64_t kNoWall = 0;
constexpr std::int64_t kClosed = 20;

/// Two places in each room: A and B below, C and D at the door. Three of the six lines between them
/// meet the wall: AB at row 6, AD and BC at row 11. CD passes the door at row 16.
const std::vector<Position> kPath{{0.85, 0.65}, {2.45, 0.65}, {0.85, 1.65}, {2.45, 1.65}};

WallKnowledge knowledgeOf(const Grid<CellState>& map) {
  return PlacePairs(twoRooms(), kPath, kMostPairs).knowledgeOf(map, std::nullopt);
}

TEST(WallKnowledge, CountsThePairsAndTheirWalls) {
  const PlacePairs pairs(twoRooms(), kPath, kMostPairs);
  EXPECT_EQ(pairs.count(), 6U);
  EXPECT_EQ(pairs.walls(), 3U);
}

TEST(WallKnowledge, OfTheTruthIsPerfect) {
  const WallKnowledge knowledge = knowledgeOf(twoRooms());
  EXPECT_EQ(knowledge.precision, 1.0);
  EXPECT_EQ(knowledge.recall, 1.0);
  EXPECT_EQ(knowledge.f1, 1.0);
  EXPECT_FALSE(knowledge.auc);
}

TEST(WallKnowledge, OfAMapWithoutTheWallIsNone) {
  const WallKnowledge knowledge = knowledgeOf(twoRooms(kNoWall));
  EXPECT_EQ(knowledge.precision, 0.0);
  EXPECT_EQ(knowledge.f1, 0.0);
}

TEST(WallKnowledge, OfHalfTheWall) {  // up to row 8: only AB is called
  const WallKnowledge knowledge = knowledgeOf(twoRooms(8));
  EXPECT_EQ(knowledge.precision, 1.0);
  EXPECT_DOUBLE_EQ(knowledge.recall.value(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(knowledge.f1.value(), 0.5);
}

TEST(WallKnowledge, OfAClosedDoor) {  // CD is called too
  const WallKnowledge knowledge = knowledgeOf(twoRooms(kClosed));
  EXPECT_DOUBLE_EQ(knowledge.precision, 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(knowledge.f1.value(), 6.0 / 7.0);
}

TEST(WallKnowledge, DoesNotAskWhereTheWallStands) {
  Grid<CellState> map = twoRooms(kNoWall);
  forEachCell({12, 1}, {14, 12}, [&](Cell c) { map[c] = CellState::kUnknown; });
  EXPECT_EQ(knowledgeOf(map).f1, 1.0);
}

TEST(WallKnowledge, OutsideTheMapNothingIsFree) {
  const Grid<CellState> elsewhere(GridGeometry(0.1, {50.0, 50.0}, 2, 2), CellState::kFree);
  EXPECT_EQ(knowledgeOf(elsewhere).recall, 1.0);
  EXPECT_DOUBLE_EQ(knowledgeOf(elsewhere).precision, 0.5);
}

TEST(WallKnowledge, ClutterIsNoWall) {
  Grid<CellState> truth = twoRooms();
  forEachCell({6, 11}, {14, 11}, [&](Cell c) { truth[c] = CellState::kOccupied; });  // 0.9 m
  EXPECT_EQ(PlacePairs(truth, kPath, kMostPairs).walls(), 3U);
  truth[{5, 12}] = CellState::kOccupied;  // touches by its corner: 1.0 m, between A and C
  EXPECT_EQ(PlacePairs(truth, kPath, kMostPairs).walls(), 4U);
}

TEST(WallKnowledge, WhatThePathTouchesIsNoWall) {
  const PlacePairs touching(twoRooms(), {{0.85, 0.65}, {1.65, 0.65}}, kMostPairs);
  EXPECT_EQ(touching.count(), 1U);
  EXPECT_EQ(touching.walls(), 0U);
}

TEST(WallKnowledge, OrderAndRepeatsOfThePathDoNotMatter) {
  std::vector<Position> path = kPath;
  path.insert(path.end(), kPath.begin(), kPath.end());
  path.emplace_back(0.87, 0.67);  // the same place as A
  std::reverse(path.begin(), path.end());
  const PlacePairs pairs(twoRooms(), path, kMostPairs);
  EXPECT_EQ(pairs.count(), 6U);
  EXPECT_EQ(pairs.knowledgeOf(twoRooms(8), std::nullopt).f1, 0.5);
}

TEST(WallKnowledge, OfPlacesTooNearOrTooFarIsNotAsked) {
  EXPECT_EQ(PlacePairs(twoRooms(), {{0.5, 0.5}, {0.95, 0.5}, {9.0, 0.5}}, kMostPairs).count(), 0U);
  EXPECT_EQ(PlacePairs(twoRooms(), {}, kMostPairs).count(), 0U);
}

TEST(WallKnowledge, WithoutAWallInTruthF1HasNoMeaning) {
  const PlacePairs pairs(twoRooms(kNoWall), kPath, kMostPairs);
  EXPECT_FALSE(pairs.knowledgeOf(twoRooms(), std::nullopt).f1);
  EXPECT_FALSE(pairs.knowledgeOf(twoRooms(), Grid<float>(twoRooms().geometry, 0.5F)).auc);
}

TEST(WallKnowledge, AucComparesTheGreatestProbabilities) {
  const PlacePairs pairs(twoRooms(), kPath, kMostPairs);
  Grid<float> probabilities(twoRooms().geometry, 0.1F);
  EXPECT_EQ(pairs.knowledgeOf(twoRooms(), probabilities).auc, 0.5);
  forEachCell({16, 1}, {16, 8}, [&](Cell c) { probabilities[c] = 0.9F; });
  // AB is above all three pairs without a wall; AD and BC are equal to them.
  EXPECT_DOUBLE_EQ(pairs.knowledgeOf(twoRooms(), probabilities).auc.value(), 2.0 / 3.0);
  forEachCell({16, 9}, {16, 12}, [&](Cell c) { probabilities[c] = 0.2F; });
  EXPECT_EQ(pairs.knowledgeOf(twoRooms(), probabilities).auc, 1.0);
}

/// The share of walls among the pairs of a drive over a hall of 20 m x 20 m with one wall.
double shareOfWalls(std::int64_t wall_column) {
  Grid<CellState> hall(GridGeometry(0.1, Position::Zero(), 200, 200), CellState::kFree);
  forEachCell({wall_column, 0}, {wall_column, 199},
              [&](Cell c) { hall[c] = CellState::kOccupied; });
  std::vector<Position> path;
  forEachCell({0, 0}, {49, 49}, [&](Cell c) {
    path.emplace_back(0.4 * static_cast<double>(c.x) + 0.2, 0.4 * static_cast<double>(c.y) + 0.2);
  });
  const PlacePairs pairs(hall, path, kMostPairs);
  EXPECT_EQ(pairs.count(), kMostPairs);
  return static_cast<double>(pairs.walls()) / static_cast<double>(pairs.count());
}

TEST(WallKnowledge, ManyPairsAreDrawnFromEverywhere) {
  // A wall in the first third has as many pairs as its mirror image in the last. The standard
  // error of a share of 6 % of 50000 is 0.1 %.
  const double first = shareOfWalls(68);
  EXPECT_GT(first, 0.03);
  EXPECT_NEAR(shareOfWalls(131), first, 0.005);
}

}  // namespace
}  // namespace sfw
