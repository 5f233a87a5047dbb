#include "simulation/radio/random_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "support/moments.h"

namespace sfw {
namespace {

using Kind = RandomField::Kind;

TEST(Random, DependsOnSeedStreamAndItemOnly) {
  EXPECT_EQ(Random(1, 2, 3).uniform(), Random(1, 2, 3).uniform());
  EXPECT_NE(Random(1, 2, 3).uniform(), Random(2, 2, 3).uniform());
  EXPECT_NE(Random(1, 2, 3).uniform(), Random(1, 3, 3).uniform());
  EXPECT_NE(Random(1, 2, 3).uniform(), Random(1, 2, 4).uniform());
}

TEST(Random, HasTheMomentsOfItsDistributions) {
  std::vector<double> uniform, normal;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Random random(1, 1, i);
    uniform.push_back(random.uniform(2.0, 4.0));
    normal.push_back(random.normal());
    EXPECT_GT(uniform.back(), 2.0);
    EXPECT_LE(uniform.back(), 4.0);
  }
  // Four standard errors of 20000 values.
  EXPECT_NEAR(test::momentsOf(uniform).mean, 3.0, 4.0 * 0.577 / 141.0);
  EXPECT_NEAR(test::momentsOf(uniform).deviation, 2.0 / std::sqrt(12.0), 0.012);
  EXPECT_NEAR(test::momentsOf(normal).mean, 0.0, 4.0 / 141.0);
  EXPECT_NEAR(test::momentsOf(normal).deviation, 1.0, 4.0 / 200.0);
}

/// Pairs of places a distance apart, in a direction that differs from pair to pair.
double correlationAt(Kind kind, double length_m, double distance_m) {
  std::vector<double> here, there;
  for (std::int64_t seed = 0; seed < 50; ++seed) {
    const RandomField field(kind, length_m, seed, 1);
    for (int i = 0; i < 100; ++i) {
      const Position place(6.0 * (i % 10), 6.0 * (i / 10));
      const double direction = 2.4 * i;
      here.push_back(field.at(place));
      there.push_back(
          field.at(place + distance_m * Position(std::cos(direction), std::sin(direction))));
    }
  }
  return test::correlationOf(here, there);
}

TEST(RandomField, CorrelationFallsAsStated) {
  // 5000 pairs, almost independent: a standard error is below 1 / sqrt(5000) = 0.014.
  constexpr double kFourErrors = 0.057;
  for (const double length : {0.6, 1.5}) {
    for (const double share : {0.25, 0.5, 1.0, 2.0, 3.0}) {
      const double distance = share * length;
      EXPECT_NEAR(correlationAt(Kind::kRough, length, distance), std::exp(-share), kFourErrors)
          << length << " m, " << share;
      EXPECT_NEAR(correlationAt(Kind::kSmooth, length, distance), std::exp(-share * share),
                  kFourErrors)
          << length << " m, " << share;
    }
  }
}

TEST(RandomField, IsNormalOverPlaces) {
  std::vector<double> values;
  for (std::int64_t seed = 0; seed < 50; ++seed) {
    const RandomField field(Kind::kRough, 0.6, seed, 1);
    for (int i = 0; i < 100; ++i) {
      values.push_back(field.at({6.0 * (i % 10), 6.0 * (i / 10)}));
    }
  }
  const test::Moments moments = test::momentsOf(values);
  EXPECT_NEAR(moments.mean, 0.0, 4.0 / std::sqrt(5000.0));
  EXPECT_NEAR(moments.deviation, 1.0, 4.0 / std::sqrt(10000.0));
  double fourth = 0.0;
  for (const double value : values) {
    fourth += std::pow(value, 4.0);
  }
  // 3 for a normal distribution, 3 - 1.5 / 128 for 128 waves; its standard error is sqrt(96 / n).
  EXPECT_NEAR(fourth / 5000.0, 3.0, 4.0 * std::sqrt(96.0 / 5000.0));
}

TEST(RandomField, OneFieldAloneHasItsDeviation) {
  // Over a large area: 60 x 60 m with a length of 1.5 m holds some hundred independent patches.
  for (std::int64_t seed = 0; seed < 10; ++seed) {
    const RandomField field(Kind::kRough, 1.5, seed, 1);
    std::vector<double> values;
    for (int i = 0; i < 3600; ++i) {
      values.push_back(field.at({1.0 * (i % 60), 1.0 * (i / 60)}));
    }
    EXPECT_NEAR(test::momentsOf(values).deviation, 1.0, 0.1) << seed;
  }
}

TEST(RandomField, StreamsAndSeedsAreIndependent) {
  std::vector<double> a, b, c;
  for (std::int64_t seed = 0; seed < 50; ++seed) {
    const RandomField first(Kind::kRough, 1.0, seed, 1), second(Kind::kRough, 1.0, seed, 2);
    const RandomField next_seed(Kind::kRough, 1.0, seed + 1000, 1);
    for (int i = 0; i < 100; ++i) {
      const Position place(6.0 * (i % 10), 6.0 * (i / 10));
      a.push_back(first.at(place));
      b.push_back(second.at(place));
      c.push_back(next_seed.at(place));
    }
  }
  EXPECT_NEAR(test::correlationOf(a, b), 0.0, 4.0 / std::sqrt(5000.0));
  EXPECT_NEAR(test::correlationOf(a, c), 0.0, 4.0 / std::sqrt(5000.0));
}

}  // namespace
}  // namespace sfw
