#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "k_visibility/sparse_inverse.h"

namespace sfw {
namespace {

using Segments = std::vector<RaySegment>;
using Masses = std::vector<double>;

TEST(SegmentRay, CutsBetweenPlacesOfKnownCount) {
  EXPECT_EQ(segmentRay({{0, 0}, {5, 0}}), (Segments{{1, 5, 0}}));
  EXPECT_EQ(segmentRay({{0, 0}, {5, 2}}), (Segments{{1, 5, 2}}));
  EXPECT_EQ(segmentRay({{0, 0}, {4, 1}, {9, 1}, {12, 3}}),
            (Segments{{1, 4, 1}, {5, 9, 0}, {10, 12, 2}}));
}

TEST(SegmentRay, TellsContradictingCounts) {
  EXPECT_EQ(segmentRay({{0, 0}, {4, 2}, {8, 1}}), (Segments{{1, 4, 2}, {5, 8, -1}}));
}

TEST(SegmentRay, LeavesOutStretchesWithoutCells) {
  EXPECT_EQ(segmentRay({{0, 0}, {1, 0}, {2, 1}, {4, 1}}), (Segments{{3, 4, 0}}));
}

TEST(SegmentRay, HasNoSegmentsWithoutAnEnd) {
  EXPECT_EQ(segmentRay({}), Segments());
  EXPECT_EQ(segmentRay({{0, 0}}), Segments());
}

double sum(const Masses& masses) { return std::accumulate(masses.begin(), masses.end(), 0.0); }

TEST(WallMass, AddsUpToTheWalls) {
  for (const int walls : {1, 2, 3}) {
    for (const double wall_cells : {0.5, 1.0, 2.0}) {
      const Masses masses = wallMass(60, walls, wall_cells);
      ASSERT_EQ(masses.size(), 60U);
      EXPECT_NEAR(sum(masses), walls * wall_cells, 1e-12) << walls;
    }
  }
}

TEST(WallMass, IsSymmetric) {
  for (const int walls : {1, 2, 3}) {
    for (const std::size_t cells : {7U, 40U, 41U}) {
      const Masses masses = wallMass(cells, walls, 1.0);
      for (std::size_t i = 0; i < cells; ++i) {
        EXPECT_NEAR(masses[i], masses[cells - 1 - i], 1e-12);
      }
    }
  }
}

/// Places of the strict local maxima.
std::vector<std::size_t> modes(const Masses& masses) {
  std::vector<std::size_t> places;
  for (std::size_t i = 1; i + 1 < masses.size(); ++i) {
    if (masses[i] > masses[i - 1] && masses[i] > masses[i + 1]) {
      places.push_back(i);
    }
  }
  return places;
}

TEST(WallMass, HasOneBellForEachWallEvenlyPlaced) {
  EXPECT_EQ(modes(wallMass(45, 1, 1.0)), (std::vector<std::size_t>{22}));
  EXPECT_EQ(modes(wallMass(42, 2, 1.0)), (std::vector<std::size_t>{10, 31}));
  EXPECT_EQ(modes(wallMass(45, 3, 1.0)), (std::vector<std::size_t>{7, 22, 37}));
}

TEST(WallMass, FallsOffAsABellOfAQuarterOfItsStretch) {
  const Masses one = wallMass(41, 1, 1.0);
  EXPECT_NEAR(one[20 + 8] / one[20], std::exp(-0.5 * (8 / 10.25) * (8 / 10.25)), 1e-12);
  const Masses two = wallMass(82, 2, 1.0);  // the other bell is four deviations away
  EXPECT_NEAR(two[20 + 8] / two[20], one[20 + 8] / one[20], 0.01);
}

TEST(WallMass, IsNeverMoreThanCertain) {
  EXPECT_EQ(wallMass(1, 1, 1.0), Masses{1.0});
  EXPECT_EQ(wallMass(1, 1, 3.0), Masses{1.0});
  EXPECT_EQ(wallMass(1, 3, 0.5), Masses{1.0});
  EXPECT_EQ(wallMass(1, 1, 0.25), Masses{0.25});
  for (const double mass : wallMass(4, 3, 2.0)) {
    EXPECT_LE(mass, 1.0);
  }
}

TEST(WallMass, IsNothingWithoutWalls) {
  EXPECT_EQ(wallMass(4, 0, 1.0), Masses(4, 0.0));
  EXPECT_EQ(wallMass(4, -1, 1.0), Masses(4, 0.0));
  EXPECT_EQ(wallMass(0, 1, 1.0), Masses());
}

}  // namespace
}  // namespace sfw
