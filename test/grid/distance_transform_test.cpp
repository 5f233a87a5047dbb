#include "grid/distance_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "grid/for_each_cell.h"
#include "support/ascii_world.h"

namespace sfw {
namespace {

using Rows = std::vector<std::string>;
using test::mask;

double nearestByHand(const Mask& set, Cell from) {
  double nearest = std::numeric_limits<double>::infinity();
  forEachCell(set.geometry, [&](Cell c) {
    if (set[c] != 0) {
      const auto squared = (c.x - from.x) * (c.x - from.x) + (c.y - from.y) * (c.y - from.y);
      nearest = std::min(nearest, std::sqrt(static_cast<double>(squared)));
    }
  });
  return nearest;
}

void expectExact(const Mask& set) {
  const Grid<double> distance = distanceTransform(set);
  forEachCell(set.geometry, [&](Cell c) {
    ASSERT_EQ(distance[c], nearestByHand(set, c)) << "cell " << c.x << ", " << c.y;
  });
}

TEST(DistanceTransform, CountsCellsFromOneCell) {
  const Grid<double> distance = distanceTransform(mask({".....",  //
                                                        ".....",  //
                                                        "..#..",  //
                                                        "....."}));
  // Squares of the distances.
  EXPECT_EQ(
      test::rowsOf(distance, [](double d) { return static_cast<char>('0' + std::lround(d * d)); }),
      (Rows{"85458",  //
            "52125",  //
            "41014",  //
            "52125"}));
}

TEST(DistanceTransform, TakesTheNearestOfSeveral) {
  const Grid<double> distance = distanceTransform(mask({"#....#"}));
  EXPECT_EQ(
      test::rowsOf(distance, [](double d) { return static_cast<char>('0' + std::lround(d)); }),
      (Rows{"012210"}));
}

TEST(DistanceTransform, OfAnEmptySetIsInfinite) {
  for (const double d : distanceTransform(mask({"...", "..."})).cells) {
    EXPECT_EQ(d, std::numeric_limits<double>::infinity());
  }
}

TEST(DistanceTransform, OfAFullSetIsZero) {
  for (const double d : distanceTransform(mask({"##", "##", "##"})).cells) {
    EXPECT_EQ(d, 0.0);
  }
}

TEST(DistanceTransform, AgreesWithASearchOfAllCells) {
  std::mt19937 random(7);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {23, 17}, {9, 31}}) {
    for (const double density : {0.01, 0.1, 0.5, 0.95}) {
      Mask set(GridGeometry(1.0, {0.0, 0.0}, width, height));
      std::bernoulli_distribution in(density);
      std::generate(set.cells.begin(), set.cells.end(),
                    [&] { return static_cast<std::uint8_t>(in(random)); });
      expectExact(set);
    }
  }
}

TEST(DistanceTransform, IsExactOverTheLongestSide) {
  constexpr std::int64_t kLongest = std::int64_t{1} << 18;
  Mask set(GridGeometry(1.0, {0.0, 0.0}, kLongest, 2));
  set[{0, 0}] = 1;
  const Grid<double> distance = distanceTransform(set);
  EXPECT_EQ((distance[{kLongest - 1, 0}]), static_cast<double>(kLongest - 1));
  EXPECT_EQ((distance[{3, 1}]), std::sqrt(10.0));
}

}  // namespace
}  // namespace sfw
