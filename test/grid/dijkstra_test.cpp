#include "grid/dijkstra.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "base/random.h"
#include "grid/for_each_cell.h"

namespace sfw {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

GridGeometry sevenBySeven() { return {1.0, Position::Zero(), 7, 7}; }

/// Steps over edges from the start to each cell, around the cells that are '#'; top row first.
Grid<double> stepsFrom(Cell start, const std::vector<const char*>& picture) {
  Grid<double> steps(sevenBySeven(), kFar);
  const auto open = [&](Cell c) {
    return steps.geometry.contains(c) &&
           picture[static_cast<std::size_t>(6 - c.y)][static_cast<std::size_t>(c.x)] != '#';
  };
  Dijkstra<double> search(steps);
  search.lower(start, 0.0);
  while (const std::optional<Cell> at = search.settle()) {
    for (const Cell next : {Cell{at->x - 1, at->y}, Cell{at->x + 1, at->y}, Cell{at->x, at->y - 1},
                            Cell{at->x, at->y + 1}}) {
      if (open(next)) {
        search.lower(next, steps[*at] + 1.0);
      }
    }
  }
  return steps;
}

TEST(Dijkstra, GoesAroundWalls) {
  const Grid<double> steps = stepsFrom({0, 0}, {".......",  //
                                                ".#####.",  //
                                                ".#...#.",  //
                                                ".#.#.#.",  //
                                                ".#.#...",  //
                                                ".#.####",  //
                                                "......."});
  EXPECT_EQ((steps[{0, 0}]), 0.0);
  EXPECT_EQ((steps[{6, 0}]), 6.0);
  EXPECT_EQ((steps[{0, 6}]), 6.0);
  EXPECT_EQ((steps[{6, 6}]), 12.0);
  EXPECT_EQ((steps[{4, 4}]), 8.0);  // through the gap in the lowest wall
  EXPECT_EQ((steps[{6, 2}]), 12.0);
  EXPECT_EQ((steps[{3, 3}]), kFar);  // a wall
}

TEST(Dijkstra, DoesNotReachWhatIsShutOff) {
  const Grid<double> steps = stepsFrom({0, 0}, {".......",  //
                                                ".......",  //
                                                "..###..",  //
                                                "..#.#..",  //
                                                "..###..",  //
                                                ".......",  //
                                                "......."});
  EXPECT_EQ((steps[{3, 3}]), kFar);
  EXPECT_EQ((steps[{6, 6}]), 12.0);
}

TEST(Dijkstra, SettlesByCostAndThenInRowMajorOrder) {
  Grid<double> cost(sevenBySeven(), kFar);
  Dijkstra<double> search(cost);
  search.lower({5, 2}, 1.0);
  search.lower({2, 5}, 0.5);
  search.lower({3, 2}, 1.0);
  search.lower({6, 1}, 1.0);
  std::vector<Cell> order;
  while (const std::optional<Cell> at = search.settle()) {
    order.push_back(*at);
  }
  EXPECT_EQ(order, (std::vector<Cell>{{2, 5}, {6, 1}, {3, 2}, {5, 2}}));
}

TEST(Dijkstra, SettlesACellOnceAtItsLowestCost) {
  Grid<double> cost(sevenBySeven(), kFar);
  Dijkstra<double> search(cost);
  EXPECT_TRUE(search.lower({1, 1}, 4.0));
  EXPECT_TRUE(search.lower({1, 1}, 2.0));
  EXPECT_FALSE(search.lower({1, 1}, 2.0));
  EXPECT_FALSE(search.lower({1, 1}, 3.0));
  search.lower({0, 0}, 3.0);
  EXPECT_EQ(search.settle(), (Cell{1, 1}));
  EXPECT_EQ((cost[{1, 1}]), 2.0);
  EXPECT_EQ(search.settle(), (Cell{0, 0}));
  EXPECT_EQ(search.settle(), std::nullopt);
}

TEST(ForEachCell, VisitsRowsFromTheLowest) {
  std::vector<Cell> visited;
  forEachCell(GridGeometry(1.0, Position::Zero(), 2, 2), [&](Cell c) { visited.push_back(c); });
  EXPECT_EQ(visited, (std::vector<Cell>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
}

TEST(ForEachCell, VisitsBothCornersOfARectangle) {
  std::vector<Cell> visited;
  forEachCell(Cell{-1, 3}, Cell{0, 4}, [&](Cell c) { visited.push_back(c); });
  EXPECT_EQ(visited, (std::vector<Cell>{{-1, 3}, {0, 3}, {-1, 4}, {0, 4}}));
}

TEST(ForEachCell, VisitsNothingOfAnEmptyRectangle) {
  forEachCell(Cell{1, 0}, Cell{0, 5}, [](Cell) { FAIL(); });
}

constexpr std::int64_t kSize = 60;
const GridGeometry kSquare(0.1, {0.0, 0.0}, kSize, kSize);

/// The cells in the order in which a search from two cells settles them.
/// @param ground  the cost of a step onto each cell
template <class Search>
std::vector<std::size_t> settled(Search& search, const Grid<float>& cost,
                                 const Grid<float>& ground) {
  search.lower({3, 5}, 0.0F);
  search.lower({40, 50}, 0.0F);
  std::vector<std::size_t> order;
  while (const std::optional<Cell> cell = search.settle()) {
    order.push_back(kSquare.index(*cell));
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const Cell next{cell->x + dx, cell->y + dy};
        if (kSquare.contains(next) && next != *cell) {
          search.lower(next, cost[*cell] + ground[next]);
        }
      }
    }
  }
  return order;
}

TEST(BucketDijkstra, SettlesTheSameCellsInTheSameOrder) {
  for (const float rough : {0.0F, 1.0F, 30.0F}) {
    Grid<float> ground(kSquare);
    Random random(1, 1, 1);
    for (float& cell : ground.cells) {
      cell = 0.1F * (1.0F + rough * static_cast<float>(random.uniform()));
    }
    Grid<float> one(kSquare, 1e6F);
    Grid<float> other(kSquare, 1e6F);
    Dijkstra<float> plain(one);
    BucketDijkstra quick(other, 0.1F);
    EXPECT_EQ(settled(quick, other, ground), settled(plain, one, ground));
    EXPECT_EQ(other.cells, one.cells);
  }
}

}  // namespace
}  // namespace sfw
