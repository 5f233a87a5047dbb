#include "radio/nearest_places.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"

namespace sfw {
namespace {

using Found = std::vector<std::pair<double, int>>;

/// The same by looking at all places up to a number.
Found plainly(const std::vector<Position>& places, int entered, const Position& to,
              std::size_t count) {
  Found all;
  for (int i = 0; i < entered; ++i) {
    all.emplace_back((places[static_cast<std::size_t>(i)] - to).squaredNorm(), i);
  }
  std::sort(all.begin(), all.end());
  all.resize(std::min(count, all.size()));
  return all;
}

void expectExact(const std::vector<Position>& places) {
  NearestPlaces nearest(places);
  for (int i = 0; i < static_cast<int>(places.size()); ++i) {
    const Position& place = places[static_cast<std::size_t>(i)];
    const Position off(12.0, -7.0);
    ASSERT_EQ(nearest.nearest(place, 12), plainly(places, i, place, 12));
    ASSERT_EQ(nearest.nearest(place + off, 3), plainly(places, i, place + off, 3));
    nearest.enter(i);
  }
}

std::vector<Position> scattered(std::size_t count, const Position& size) {
  Random random(1, 1, 0);
  std::vector<Position> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform();
    places.emplace_back(size.x() * x, size.y() * random.uniform());
  }
  return places;
}

TEST(NearestPlaces, AreExactWhereScattered) {
  expectExact(scattered(400, {10.0, 10.0}));
  expectExact(scattered(400, {100.0, 0.1}));
}

TEST(NearestPlaces, AreExactOnLines) {
  expectExact(scattered(300, {10.0, 0.0}));
  expectExact(scattered(300, {0.0, 10.0}));
  std::vector<Position> slant = scattered(300, {10.0, 0.0});
  for (Position& place : slant) {
    place.y() = place.x();
  }
  expectExact(slant);
}

TEST(NearestPlaces, TellTiesByNumber) {
  std::vector<Position> lattice;
  for (int i = 0; i < 400; ++i) {
    lattice.emplace_back(0.2 * (i % 20), 0.2 * (i / 20));
  }
  expectExact(lattice);
  expectExact(std::vector<Position>(50, Position(3.0, -4.0)));
}

TEST(NearestPlaces, AreExactBesideAnOutlier) {
  std::vector<Position> places = scattered(200, {4.0, 4.0});
  places[20] = {1e6, -1e6};
  expectExact(places);
}

TEST(NearestPlaces, AreNoneWhereNothingEntered) {
  const std::vector<Position> none;
  EXPECT_TRUE(NearestPlaces(none).nearest({1.0, 2.0}, 12).empty());
}

}  // namespace
}  // namespace sfw
