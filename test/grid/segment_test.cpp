#include "grid/segment.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sfw {
namespace {

TEST(DistanceToSegment, IsThatToTheLineBesideTheSegment) {
  EXPECT_DOUBLE_EQ(distanceToSegment({2.0, 3.0}, {0.0, 1.0}, {5.0, 1.0}), 2.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({1.0, 0.0}, {0.0, 0.0}, {1.0, 1.0}), std::sqrt(0.5));
}

TEST(DistanceToSegment, IsThatToTheNearerEndBeyondIt) {
  EXPECT_DOUBLE_EQ(distanceToSegment({8.0, 5.0}, {0.0, 1.0}, {5.0, 1.0}), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({-3.0, -3.0}, {0.0, 1.0}, {5.0, 1.0}), 5.0);
}

TEST(DistanceToSegment, IsThatToThePointWhereBothEndsCoincide) {
  EXPECT_DOUBLE_EQ(distanceToSegment({3.0, 4.0}, {0.0, 0.0}, {0.0, 0.0}), 5.0);
}

TEST(DistanceToSegment, IsZeroOnTheSegment) {
  EXPECT_DOUBLE_EQ(distanceToSegment({2.0, 2.0}, {0.0, 0.0}, {4.0, 4.0}), 0.0);
}

}  // namespace
}  // namespace sfw
