#include "simulation/radio/noise_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Shadowing, sample noise and variation from wall to wall [dB].
std::vector<double> noiseOf(NoiseLevel level) {
  const RadioModel::Config radio = levelRadio(level, 1);
  return {radio.shadowing_db, radio.sample_noise_db, radio.interior_wall_variation_db};
}

TEST(NoiseLevel, FiguresAreFixed) {
  EXPECT_EQ(noiseOf(NoiseLevel::kNone), (std::vector<double>{0.0, 0.0, 0.0}));
  EXPECT_EQ(noiseOf(NoiseLevel::kLow), (std::vector<double>{1.0, 1.0, 0.5}));
  EXPECT_EQ(noiseOf(NoiseLevel::kModerate), (std::vector<double>{2.5, 2.0, 1.0}));
  EXPECT_EQ(noiseOf(NoiseLevel::kRealistic), (std::vector<double>{3.7, 3.0, 1.0}));
  EXPECT_EQ(noiseOf(NoiseLevel::kHard), (std::vector<double>{5.0, 4.0, 1.0}));
}

TEST(NoiseLevel, OnlyTheFirstIsNotRounded) {
  EXPECT_EQ(levelRadio(NoiseLevel::kNone, 1).rssi_step_db, 0.0);
  for (const auto level :
       {NoiseLevel::kLow, NoiseLevel::kModerate, NoiseLevel::kRealistic, NoiseLevel::kHard}) {
    EXPECT_EQ(levelRadio(level, 1).rssi_step_db, 1.0);
  }
}

TEST(NoiseLevel, TheTextbooksLevelsAreTheSameForAllSeeds) {
  for (const auto level : {NoiseLevel::kNone, NoiseLevel::kLow, NoiseLevel::kModerate}) {
    for (const std::int64_t seed : {1, 2}) {
      const RecordingConfig config = levelConfig(level, seed);
      EXPECT_EQ(config.radio.seed, seed);
      EXPECT_EQ(config.radio.exponent, 2.0);
      EXPECT_EQ(config.radio.interior_wall_loss_db, 6.1);
      EXPECT_EQ(config.radio.outer_wall_loss_db, 12.2);
      EXPECT_EQ(config.radio.shadowing_distance_m, 1.5);
      EXPECT_EQ(config.radio.max_obstacle_loss_db, 0.0);
      EXPECT_EQ(config.radio.max_furniture_loss_db, 0.0);
      EXPECT_EQ(config.radio.access_point_pattern_db, 0.0);
      EXPECT_EQ(config.radio.robot_pattern_db, 0.0);
      EXPECT_EQ(config.registration_error_m, 0.0);
      EXPECT_EQ(levelClearance(level, seed), 0.30);
    }
  }
}

TEST(NoiseLevel, HomesHavePatternsFurnitureAndSaturation) {
  for (const auto level : {NoiseLevel::kRealistic, NoiseLevel::kHard}) {
    const RecordingConfig config = levelConfig(level, 1);
    EXPECT_EQ(config.radio.max_obstacle_loss_db, level == NoiseLevel::kRealistic ? 15.0 : 10.0);
    EXPECT_EQ(config.radio.shadowing_distance_m, 0.6);
    EXPECT_EQ(config.radio.access_point_pattern_db, 2.0);
    EXPECT_EQ(config.radio.robot_pattern_db, 2.0);
    EXPECT_EQ(config.radio.max_furniture_loss_db, 5.0);
    EXPECT_EQ(config.radio.outer_wall_loss_db, 2.0 * config.radio.interior_wall_loss_db);
    EXPECT_EQ(config.radio.outer_wall_variation_db, 2.0);
    EXPECT_EQ(config.registration_distance_m, 3.0);
    EXPECT_EQ(config.drift, 0.0);
  }
}

/// Draws fill their range: in 300 of them, the outer twentieths are missed with odds of 2e-7.
void expectToFill(const std::function<double(std::int64_t)>& draw, double low, double high) {
  double least = high, most = low;
  for (std::int64_t seed = 0; seed < 300; ++seed) {
    const double value = draw(seed);
    EXPECT_GE(value, low);
    EXPECT_LE(value, high);
    EXPECT_EQ(value, draw(seed));
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_LT(least, low + 0.05 * (high - low));
  EXPECT_GT(most, high - 0.05 * (high - low));
}

TEST(NoiseLevel, HomesDifferFromSeedToSeed) {
  for (const auto level : {NoiseLevel::kRealistic, NoiseLevel::kHard}) {
    expectToFill([&](std::int64_t seed) { return levelRadio(level, seed).exponent; }, 1.5, 2.2);
    expectToFill([&](std::int64_t seed) { return levelRadio(level, seed).interior_wall_loss_db; },
                 6.0, 11.0);
    expectToFill([&](std::int64_t seed) { return levelConfig(level, seed).registration_error_m; },
                 0.03, 0.18);
    expectToFill([&](std::int64_t seed) { return levelClearance(level, seed); }, 0.10, 0.42);
  }
}

TEST(NoiseLevel, NamesAreReadBack) {
  for (const auto level : {NoiseLevel::kNone, NoiseLevel::kLow, NoiseLevel::kModerate,
                           NoiseLevel::kRealistic, NoiseLevel::kHard}) {
    EXPECT_EQ(parseNoiseLevel(nameOf(level)), level);
    EXPECT_TRUE(validate(levelConfig(level, 1)).empty());
  }
  try {
    parseNoiseLevel("Low");
    FAIL() << "names are in lower case";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "'Low' is no noise level; there are none, low, ideal, realistic, hard");
  }
}

}  // namespace
}  // namespace sfw
