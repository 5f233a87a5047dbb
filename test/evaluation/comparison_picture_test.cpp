#include "evaluation/comparison_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "structure_from_wifi/input_error.h"
#include "support/evaluation_world.h"
#include "support/png_colours.h"

namespace sfw::test {
namespace {

constexpr std::uint32_t kWall = 0x1a1a1f, kMissed = 0x7399d9, kTakenForFree = 0xd91a1a,
                        kWhereFree = 0xf29a1a, kTrueWall = 0xed8c80;

int pixelsOf(const std::map<std::uint32_t, int>& colours, std::uint32_t wanted) {
  int pixels = 0;
  for (const auto& [colour, count] : colours) {
    const auto near = [&, seen = colour](int shift) {
      return std::abs(static_cast<int>(seen >> shift & 0xff) -
                      static_cast<int>(wanted >> shift & 0xff)) <= 1;
    };
    pixels += near(16) && near(8) && near(0) ? count : 0;
  }
  return pixels;
}

bool isThere(const std::map<std::uint32_t, int>& colours, std::uint32_t wanted) {
  constexpr int kLegend = 300;  // pixels that a legend's box has at most
  return pixelsOf(colours, wanted) > kLegend;
}

EvaluationInput corridor(const std::string& map, const std::string& truth) {
  return input(Rows(5, map), Rows(5, truth), along(1, 2, 2));
}

std::string panels(const std::string& map, const std::string& truth) {
  const EvaluationInput judged = corridor(map, truth);
  return renderPanels(judged, "note", {{"map", "its note", judged.map}}, false);
}

TEST(ComparisonPicture, ATrueMapHasNothingMissed) {
  const auto colours = coloursOf(renderComparison(input(kRooms, kRooms, along(1, 5, 3))));
  EXPECT_TRUE(isThere(colours, kWall));
  EXPECT_FALSE(isThere(colours, kMissed));
  EXPECT_FALSE(isThere(colours, kTakenForFree));
  EXPECT_FALSE(isThere(colours, kWhereFree));
}

TEST(ComparisonPicture, WallsAgreeWithinTwoCells) {
  const auto near = coloursOf(renderComparison(corridor("......#...", "....#.....")));
  EXPECT_TRUE(isThere(near, kWall));
  EXPECT_FALSE(isThere(near, kTakenForFree));
  EXPECT_FALSE(isThere(near, kWhereFree));
  const auto far = coloursOf(renderComparison(corridor(".......#..", "....#.....")));
  EXPECT_FALSE(isThere(far, kWall));
  EXPECT_TRUE(isThere(far, kTakenForFree));
  EXPECT_TRUE(isThere(far, kWhereFree));
}

TEST(ComparisonPicture, WhatTheMapDoesNotKnowIsMissed) {
  const auto colours = coloursOf(renderComparison(corridor("..???..???", "...#......")));
  EXPECT_TRUE(isThere(colours, kMissed));
  EXPECT_FALSE(isThere(colours, kTakenForFree));
}

TEST(ComparisonPicture, TheGridsMayDiffer) {
  EvaluationInput coarse = corridor("....#.....", "....#.....");
  coarse.map = Grid<CellState>(GridGeometry(0.5, {-10.0, -10.0}, 4, 4), CellState::kFree);
  EXPECT_TRUE(isThere(coloursOf(renderComparison(coarse)), kMissed));  // beyond the map
  coarse.map = Grid<CellState>(GridGeometry(0.5, {-1.0, -1.0}, 4, 4), CellState::kFree);
  EXPECT_TRUE(isThere(coloursOf(renderComparison(coarse)), kTakenForFree));
}

TEST(MapPanels, TrueWallsShowWhereTheMapHasNone) {
  const auto drawn = coloursOf(panels("....#.....", "....#....."));
  EXPECT_TRUE(isThere(drawn, kWall));
  EXPECT_FALSE(isThere(drawn, kTrueWall));
  const auto missed = coloursOf(panels("..........", "....#....."));
  EXPECT_TRUE(isThere(missed, kTrueWall));
}

TEST(MapPanels, StayWithinTheTruthsArea) {
  EvaluationInput judged = corridor("....", "....");
  judged.map = Grid<CellState>(GridGeometry(0.5, {-50.0, -50.0}, 200, 200), CellState::kOccupied);
  const auto colours = coloursOf(renderPanels(judged, "", {{"map", "", judged.map}}, false));
  const int walls = pixelsOf(colours, kWall);
  EXPECT_GT(walls, 0.9 * 388 * 388);  // the whole panel ...
  EXPECT_LT(walls, 1.1 * 388 * 440);  // ... and no other
}

TEST(ComparisonPicture, ATruthThatKnowsNothingIsRefused) {
  EXPECT_THROW(renderComparison(corridor("....", "????")), InputError);
  EXPECT_THROW(panels("....", "????"), InputError);
}

}  // namespace
}  // namespace sfw::test
