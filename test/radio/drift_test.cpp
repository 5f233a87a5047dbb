#include "radio/drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "simulation/building/floor_plan_generator.h"
#include "simulation/radio/random_field.h"
#include "simulation/scenario.h"
#include "support/recorded_readings.h"

namespace sfw {
namespace {

/// Twice round a square of 6 m, in a field of signals that changes over 1.5 m; the second time the
/// poses are off by `error`.
std::vector<Sample> twoLaps(const Position& error, double noise_db = 1.0) {
  constexpr double kEdge = 6.0;
  constexpr int kSteps = 60;  // along an edge
  const RandomField field(RandomField::Kind::kSmooth, 1.5, 3, 4);
  Random random(5, 6, 7);
  const Position corners[] = {{0, 0}, {kEdge, 0}, {kEdge, kEdge}, {0, kEdge}, {0, 0}};
  std::vector<Sample> samples;
  for (int lap = 0; lap < 2; ++lap) {
    for (int edge = 0; edge < 4; ++edge) {
      for (int i = 0; i < kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        const Position place = corners[edge] + share * (corners[edge + 1] - corners[edge]);
        const double rssi_dbm = -60.0 + 6.0 * field.at(place) + noise_db * random.normal();
        samples.push_back({place + lap * error, rssi_dbm});
      }
    }
  }
  return samples;
}

TEST(Drift, TrustsAPathThatComesBackToWhereItSays) {
  const auto check = checkDrift({twoLaps(Position::Zero())});
  ASSERT_TRUE(check);
  EXPECT_LT(check->ratio, 0.2);
  EXPECT_GT(check->returns, 60U);
  EXPECT_FALSE(check->suspect);
}

TEST(Drift, SuspectsAPathThatDoesNot) {
  // Along one axis, so that two edges of the laps still lie on each other.
  const auto check = checkDrift({twoLaps(Position(2.5, 0.0))});
  ASSERT_TRUE(check);
  EXPECT_GT(check->ratio, 0.6);
  EXPECT_TRUE(check->suspect);
}

TEST(Drift, TakesTheJitterOfAStandingRobotForNoWay) {
  std::vector<Sample> samples = twoLaps(Position::Zero());
  samples.resize(samples.size() / 2);  // one lap: it comes back to nothing
  Random random(8, 9, 10);
  for (int i = 0; i < 2000; ++i) {
    const Position jitter(0.02 * random.normal(), 0.02 * random.normal());
    samples.push_back({samples.front().antenna_in_map + jitter, -60.0 + random.normal()});
  }
  EXPECT_FALSE(checkDrift({samples}));
}

TEST(Drift, TakesNoiseOff) {
  const auto quiet = checkDrift({twoLaps(Position::Zero(), 0.0)});
  const auto loud = checkDrift({twoLaps(Position::Zero(), 5.0)});
  ASSERT_TRUE(quiet);
  ASSERT_TRUE(loud);
  EXPECT_NEAR(loud->ratio, quiet->ratio, 0.2);
  EXPECT_FALSE(loud->suspect);
}

TEST(Drift, HearsAllAccessPointsTogether) {
  const std::vector<Sample> one = twoLaps(Position::Zero());
  const auto alone = checkDrift({one});
  const auto twice = checkDrift({one, one, {}});
  ASSERT_TRUE(alone);
  ASSERT_TRUE(twice);
  EXPECT_NEAR(twice->ratio, alone->ratio, 1e-9);
  EXPECT_EQ(twice->returns, 2 * alone->returns);
}

TEST(Drift, SaysNothingOfTooLittle) {
  EXPECT_FALSE(checkDrift({}));
  EXPECT_FALSE(checkDrift({{}, {}}));
  EXPECT_FALSE(checkDrift({{{Position(1, 2), -50.0}}}));
  std::vector<Sample> samples = twoLaps(Position::Zero());
  samples.resize(samples.size() / 2);  // one lap: it never comes back
  EXPECT_FALSE(checkDrift({samples}));
  EXPECT_FALSE(checkDrift({std::vector<Sample>(1000, {Position(1, 2), -50.0})})) << "stands still";
}

TEST(Drift, SaysNothingOfSignalsThatAreAllAlike) {
  std::vector<Sample> samples = twoLaps(Position(2.5, 0.0));
  for (Sample& sample : samples) {
    sample.rssi_dbm = -60.0;
  }
  EXPECT_FALSE(checkDrift({samples}));
}

std::vector<std::vector<Sample>> byRadio(const std::vector<Reading>& readings) {
  std::vector<std::vector<Sample>> all;
  for (const auto& [bssid, samples] : test::samplesByRadio(readings)) {
    all.push_back(samples);
  }
  return all;
}

/// A flat, driven along its walls at `realistic` noise.
std::optional<DriftCheck> inAFlat(std::uint64_t seed, double drift) {
  BuildingConfig building;
  building.seed = seed;
  ScenarioConfig config;
  config.access_points = 2;
  config.seed = static_cast<std::int64_t>(seed);
  Scenario scenario = makeScenario(generateFloorPlan(building), {}, config);
  scenario.recording.drift = drift;
  return checkDrift(byRadio(simulate(scenario).readings));
}

TEST(Drift, IsFoundInSimulatedFlats) {
  for (const std::uint64_t seed : {9001U, 9002U, 9003U}) {
    const auto good = inAFlat(seed, 0.0);
    const auto drifting = inAFlat(seed, 0.04);
    ASSERT_TRUE(good);
    ASSERT_TRUE(drifting);
    EXPECT_FALSE(good->suspect) << seed << ": " << good->ratio;
    EXPECT_TRUE(drifting->suspect) << seed << ": " << drifting->ratio;
  }
}

TEST(Drift, IsNotFoundInRealRecordings) {
  const std::vector<test::RealRecording> recordings = test::realRecordings();
  if (recordings.empty()) {
    GTEST_SKIP() << test::kNoRecordings;
  }
  for (const test::RealRecording& recording : recordings) {
    const auto check = checkDrift(byRadio(recording.readings));
    ASSERT_TRUE(check) << recording.name;
    EXPECT_FALSE(check->suspect) << recording.name << ": " << check->ratio;
  }
}

}  // namespace
}  // namespace sfw
