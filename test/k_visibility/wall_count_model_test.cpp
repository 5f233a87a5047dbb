#include "k_visibility/wall_count_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace sfw {
namespace {

using Values = std::vector<double>;

/// Sum of squares about the means of the groups that `group` makes.
double scatter(const Values& values, const std::function<std::size_t(double)>& group) {
  std::vector<Values> groups(values.size() + 1);
  for (const double value : values) {
    groups[group(value)].push_back(value);
  }
  double sum = 0.0;
  for (const Values& members : groups) {
    double mean = 0.0;
    for (const double member : members) {
      mean += member / static_cast<double>(members.size());
    }
    for (const double member : members) {
      sum += (member - mean) * (member - mean);
    }
  }
  return sum;
}

/// The least scatter of all cuts of the sorted values into `groups` intervals.
double leastScatter(const Values& sorted, std::size_t groups, Values& borders) {
  if (borders.size() + 1 == groups) {
    return scatter(sorted, [&](double value) {
      return static_cast<std::size_t>(std::upper_bound(borders.begin(), borders.end(), value) -
                                      borders.begin());
    });
  }
  double least = std::numeric_limits<double>::infinity();
  for (const double border : sorted) {
    if (borders.empty() || border > borders.back()) {
      borders.push_back(border);
      least = std::min(least, leastScatter(sorted, groups, borders));
      borders.pop_back();
    }
  }
  return least;
}

TEST(WallCountModel, FindsTheBestClusteringOfAll) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    const std::size_t count = 4 + random() % 8;
    const std::size_t walls = 1 + random() % 3;
    Values values;
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(-static_cast<double>(300 + random() % 500) / 10.0);
    }
    Values sorted = values;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
      continue;  // fewer distinct values have a test of their own
    }
    const auto model = WallCountModel::fit(values, walls);
    ASSERT_EQ(model.walls(), walls);
    Values borders;
    const double best = leastScatter(sorted, walls + 1, borders);
    const double found =
        scatter(values, [&](double value) { return static_cast<std::size_t>(model.count(value)); });
    ASSERT_NEAR(found, best, 1e-6);
  }
}

TEST(WallCountModel, HasTheMeansOfItsGroupsAsCentroids) {
  const auto model = WallCountModel::fit({-41, -60, -40, -62, -39, -61}, 1);
  ASSERT_EQ(model.centroids().size(), 2U);
  EXPECT_NEAR(model.centroids()[0], -40.0, 1e-9);
  EXPECT_NEAR(model.centroids()[1], -61.0, 1e-9);
  ASSERT_EQ(model.thresholds().size(), 1U);
  EXPECT_NEAR(model.thresholds()[0], -50.5, 1e-9);
}

TEST(WallCountModel, DoesNotDependOnOrder) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 6.0);
  Values values;
  for (int i = 0; i < 500; ++i) {
    values.push_back(-50.0 - 10.0 * (i % 3) + noise(random));
  }
  const auto model = WallCountModel::fit(values, 3);
  const auto chosen = WallCountModel::choose(values, 6, 1.0);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(values.begin(), values.end(), random);
    EXPECT_EQ(WallCountModel::fit(values, 3).centroids(), model.centroids());
    EXPECT_EQ(WallCountModel::choose(values, 6, 1.0).centroids(), chosen.centroids());
  }
}

TEST(WallCountModel, HasStrictlyDecreasingThresholds) {
  std::mt19937 random(6);
  for (int round = 0; round < 100; ++round) {
    Values values;
    for (std::size_t i = 0; i < 1 + random() % 40; ++i) {
      values.push_back(-static_cast<double>(random() % 30) / 10.0);
    }
    const auto model = WallCountModel::fit(values, 1 + random() % 8);
    const Values& thresholds = model.thresholds();
    ASSERT_EQ(std::adjacent_find(thresholds.begin(), thresholds.end(), std::less_equal<>()),
              thresholds.end());
    ASSERT_EQ(model.centroids().size(), thresholds.size() + 1);
  }
}

TEST(WallCountModel, CountsTheThresholdsThatASignalDoesNotExceed) {
  // t_1 = -50 and t_2 = -70: f(P) is 0 above t_1, k down to t_(k+1), and K from t_K on.
  const auto model = WallCountModel::fit({-40, -60, -80}, 2);
  ASSERT_EQ(model.thresholds(), (Values{-50, -70}));
  EXPECT_EQ(model.count(0.0), 0);
  EXPECT_EQ(model.count(-49.9), 0);
  EXPECT_EQ(model.count(std::nextafter(-50.0, 0.0)), 0);
  EXPECT_EQ(model.count(-50.0), 1);
  EXPECT_EQ(model.count(-69.9), 1);
  EXPECT_EQ(model.count(-70.0), 2);
  EXPECT_EQ(model.count(-119.0), 2);
}

TEST(WallCountModel, HasFewerWallsThanAskedIfValuesAreFew) {
  EXPECT_EQ(WallCountModel::fit({-50, -50, -50}, 3).walls(), 0U);
  EXPECT_EQ(WallCountModel::fit({-50, -60, -50}, 3).walls(), 1U);
  EXPECT_EQ(WallCountModel::fit({-50.01, -50.02}, 1).walls(), 0U);  // one step of 0.1 dB
}

TEST(WallCountModel, AnswersZeroWithoutData) {
  for (const auto& model : {WallCountModel::fit({}, 3), WallCountModel::choose({}, 3, 5.0)}) {
    EXPECT_EQ(model.walls(), 0U);
    EXPECT_TRUE(model.centroids().empty());
    EXPECT_EQ(model.count(-90.0), 0);
  }
}

// ---- The choice of K ----

/// `count` values around each centre.
Values clusters(const Values& centres, double sd, std::uint32_t seed, int count = 60) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, sd);
  Values values;
  for (const double centre : centres) {
    for (int i = 0; i < count; ++i) {
      values.push_back(centre + noise(random));
    }
  }
  return values;
}

TEST(Choice, FindsClearClusters) {
  EXPECT_EQ(WallCountModel::choose(clusters({-40, -52}, 1.0, 1), 6, 5.0).walls(), 1U);
  EXPECT_EQ(WallCountModel::choose(clusters({-40, -52, -64}, 1.0, 2), 6, 5.0).walls(), 2U);
  const auto model = WallCountModel::choose(clusters({-35, -45, -58, -70}, 1.0, 3), 6, 5.0);
  ASSERT_EQ(model.walls(), 3U);
  EXPECT_NEAR(model.centroids()[0], -35.0, 0.5);
  EXPECT_NEAR(model.centroids()[1], -45.0, 0.5);
  EXPECT_NEAR(model.centroids()[2], -58.0, 0.5);
  EXPECT_NEAR(model.centroids()[3], -70.0, 0.5);
}

TEST(Choice, SeesNoWallInASingleCluster) {
  EXPECT_EQ(WallCountModel::choose(clusters({-50}, 2.0, 4, 500), 6, 5.0).walls(), 0U);
  EXPECT_EQ(WallCountModel::choose({-50}, 6, 5.0).walls(), 0U);
  EXPECT_EQ(WallCountModel::choose({-50, -50, -50}, 6, 5.0).walls(), 0U);
}

TEST(Choice, KeepsCentroidsApart) {
  const Values values = clusters({-40, -44}, 0.2, 5);
  EXPECT_EQ(WallCountModel::choose(values, 6, 3.0).walls(), 1U);
  EXPECT_EQ(WallCountModel::choose(values, 6, 5.0).walls(), 0U);
  EXPECT_EQ(WallCountModel::choose({-40, -45}, 6, 5.0).walls(), 1U);  // exactly apart
}

TEST(Choice, StaysWithinTheMostWalls) {
  const Values values = clusters({-30, -42, -54, -66}, 1.0, 6);
  EXPECT_EQ(WallCountModel::choose(values, 3, 5.0).walls(), 3U);
  EXPECT_LE(WallCountModel::choose(values, 2, 5.0).walls(), 2U);
}

}  // namespace
}  // namespace sfw
