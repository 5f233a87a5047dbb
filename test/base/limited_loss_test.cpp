#include "base/limited_loss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sfw {
namespace {

TEST(LimitedLoss, AddsUpWithoutALimit) {
  EXPECT_EQ(limitedLoss(42.0, 0.0), 42.0);
  EXPECT_EQ(limitedLoss(42.0, std::numeric_limits<double>::infinity()), 42.0);
}

TEST(LimitedLoss, ApproachesTheLimit) {
  EXPECT_EQ(limitedLoss(0.0, 15.0), 0.0);
  EXPECT_NEAR(limitedLoss(0.01, 15.0), 0.01, 1e-5);
  EXPECT_NEAR(limitedLoss(15.0, 15.0), 15.0 * (1.0 - std::exp(-1.0)), 1e-12);
  EXPECT_NEAR(limitedLoss(1000.0, 15.0), 15.0, 1e-12);
}

}  // namespace
}  // namespace sfw
