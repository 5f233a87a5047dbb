#include "radio/nearest_neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"

namespace sfw {
namespace {

using Found = std::vector<std::pair<double, int>>;

/// The same by looking at all positions up to a number.
Found plainly(const std::vector<Position>& positions, int entered, const Position& to,
              std::size_t count) {
  Found all;
  for (int i = 0; i < entered; ++i) {
    all.emplace_back((positions[static_cast<std::size_t>(i)] - to).squaredNorm(), i);
  }
  std::sort(all.begin(), all.end());
  all.resize(std::min(count, all.size()));
  return all;
}

void expectExact(const std::vector<Position>& positions) {
  NearestNeighbours nearest(positions);
  for (int i = 0; i < static_cast<int>(positions.size()); ++i) {
    const Position& position = positions[static_cast<std::size_t>(i)];
    const Position off(12.0, -7.0);
    ASSERT_EQ(nearest.nearest(position, 12), plainly(positions, i, position, 12));
    ASSERT_EQ(nearest.nearest(position + off, 3), plainly(positions, i, position + off, 3));
    nearest.enter(i);
  }
}

std::vector<Position> scattered(std::size_t count, const Position& size) {
  Random random(1, 1, 0);
  std::vector<Position> positions;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform();
    positions.emplace_back(size.x() * x, size.y() * random.uniform());
  }
  return positions;
}

TEST(NearestNeighbours, AreExactWhereScattered) {
  expectExact(scattered(400, {10.0, 10.0}));
  expectExact(scattered(400, {100.0, 0.1}));
}

TEST(NearestNeighbours, AreExactOnLines) {
  expectExact(scattered(300, {10.0, 0.0}));
  expectExact(scattered(300, {0.0, 10.0}));
  std::vector<Position> slant = scattered(300, {10.0, 0.0});
  for (Position& position : slant) {
    position.y() = position.x();
  }
  expectExact(slant);
}

TEST(NearestNeighbours, TellTiesByNumber) {
  std::vector<Position> lattice;
  for (int i = 0; i < 400; ++i) {
    lattice.emplace_back(0.2 * (i % 20), 0.2 * (i / 20));
  }
  expectExact(lattice);
  expectExact(std::vector<Position>(50, Position(3.0, -4.0)));
}

TEST(NearestNeighbours, AreExactBesideAnOutlier) {
  std::vector<Position> positions = scattered(200, {4.0, 4.0});
  positions[20] = {1e6, -1e6};
  expectExact(positions);
}

TEST(NearestNeighbours, AreNoneWhereNothingEntered) {
  const std::vector<Position> none;
  EXPECT_TRUE(NearestNeighbours(none).nearest({1.0, 2.0}, 12).empty());
}

}  // namespace
}  // namespace sfw
