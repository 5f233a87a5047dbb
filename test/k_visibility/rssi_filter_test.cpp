#include "k_visibility/rssi_filter.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace sfw {
namespace {

using Values = std::vector<double>;

TEST(SlidingMedian, ShrinksItsWindowAtTheEnds) {
  EXPECT_EQ(slidingMedian({9, 1, 2, 8, 3}, 3), (Values{9, 2, 2, 3, 3}));
  EXPECT_EQ(slidingMedian({9, 1, 2, 8, 3}, 5), (Values{9, 2, 3, 3, 3}));
  EXPECT_EQ(slidingMedian({9, 1, 2, 8, 3}, 99), (Values{9, 2, 3, 3, 3}));
}

TEST(SlidingMedian, DropsASingleOutlier) {
  EXPECT_EQ(slidingMedian({-50, -50, -90, -50, -50}, 3), Values(5, -50.0));
}

TEST(SlidingMean, ShrinksItsWindowAtTheEnds) {
  EXPECT_EQ(slidingMean({9, 0, 3, 6, 3}, 3), (Values{9, 4, 3, 4, 3}));
}

TEST(SlidingFilters, KeepALinearTrend) {
  const Values trend{-40, -42, -44, -46, -48, -50, -52};
  for (const std::size_t window : {1U, 3U, 5U, 7U, 101U}) {
    EXPECT_EQ(slidingMedian(trend, window), trend) << window;
    EXPECT_EQ(slidingMean(trend, window), trend) << window;
  }
}

TEST(SlidingFilters, TakeAnyNumberOfValues) {
  EXPECT_EQ(slidingMedian({}, 5), Values());
  EXPECT_EQ(slidingMean({}, 5), Values());
  EXPECT_EQ(slidingMedian({-7}, 5), Values{-7});
  EXPECT_EQ(slidingMean({-7, -3}, 5), (Values{-7, -3}));
}

TEST(WithoutPathLoss, GivesBackTheLossByDistance) {
  EXPECT_DOUBLE_EQ(withoutPathLoss(-50.0, 1.0, 2.0), -50.0);
  EXPECT_DOUBLE_EQ(withoutPathLoss(-50.0, 10.0, 2.0), -30.0);
  EXPECT_DOUBLE_EQ(withoutPathLoss(-50.0, 100.0, 1.2), -26.0);
  EXPECT_DOUBLE_EQ(withoutPathLoss(-50.0, 7.0, 0.0), -50.0);
}

TEST(WithoutPathLoss, EndsNearTheAccessPoint) {
  const double nearest = withoutPathLoss(-50.0, 0.3, 2.0);
  EXPECT_DOUBLE_EQ(withoutPathLoss(-50.0, 0.0, 2.0), nearest);
  EXPECT_DOUBLE_EQ(withoutPathLoss(-50.0, 0.29, 2.0), nearest);
  EXPECT_GT(withoutPathLoss(-50.0, 0.31, 2.0), nearest);
}

}  // namespace
}  // namespace sfw
