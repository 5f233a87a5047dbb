#include "simulation/radio/noise_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Shadowing, sample noise and variation from wall to wall [dB].
std::vector<double> noiseOf(NoiseLevel level) {
  const RadioModel::Config radio = radioConfig(level, 1);
  return {radio.shadowing_db, radio.sample_noise_db, radio.interior_wall_variation_db};
}

TEST(NoiseLevel, FiguresAreFixed) {
  EXPECT_EQ(noiseOf(noiseLevel("none")), (std::vector<double>{0.0, 0.0, 0.0}));
  EXPECT_EQ(noiseOf(noiseLevel("low")), (std::vector<double>{1.0, 1.0, 0.5}));
  EXPECT_EQ(noiseOf(noiseLevel("moderate")), (std::vector<double>{2.5, 2.0, 1.0}));
  EXPECT_EQ(noiseOf(noiseLevel("realistic")), (std::vector<double>{3.7, 3.0, 1.0}));
  EXPECT_EQ(noiseOf(noiseLevel("hard")), (std::vector<double>{5.0, 4.0, 1.0}));
}

TEST(NoiseLevel, OnlyTheFirstIsNotRounded) {
  EXPECT_EQ(radioConfig(noiseLevel("none"), 1).rssi_step_db, 0.0);
  for (const NoiseLevel& level :
       {noiseLevel("low"), noiseLevel("moderate"), noiseLevel("realistic"), noiseLevel("hard")}) {
    EXPECT_EQ(radioConfig(level, 1).rssi_step_db, 1.0);
  }
}

TEST(NoiseLevel, TheTextbooksLevelsAreTheSameForAllSeeds) {
  for (const NoiseLevel& level : {noiseLevel("none"), noiseLevel("low"), noiseLevel("moderate")}) {
    for (const std::int64_t seed : {1, 2}) {
      const RecordingConfig config = recordingConfig(level, seed);
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
      EXPECT_EQ(wallClearance(level, seed), 0.30);
    }
  }
}

TEST(NoiseLevel, HomesHavePatternsFurnitureAndSaturation) {
  for (const NoiseLevel& level : {noiseLevel("realistic"), noiseLevel("hard")}) {
    const RecordingConfig config = recordingConfig(level, 1);
    EXPECT_EQ(config.radio.max_obstacle_loss_db, level.name == "realistic" ? 15.0 : 10.0);
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
  for (const NoiseLevel& level : {noiseLevel("realistic"), noiseLevel("hard")}) {
    expectToFill([&](std::int64_t seed) { return radioConfig(level, seed).exponent; }, 1.5, 2.2);
    expectToFill([&](std::int64_t seed) { return radioConfig(level, seed).interior_wall_loss_db; },
                 6.0, 11.0);
    expectToFill(
        [&](std::int64_t seed) { return recordingConfig(level, seed).registration_error_m; }, 0.03,
        0.18);
    expectToFill([&](std::int64_t seed) { return wallClearance(level, seed); }, 0.10, 0.42);
  }
}

TEST(NoiseLevel, NamesAreReadBack) {
  for (const std::string& name : noiseLevelNames()) {
    EXPECT_EQ(noiseLevel(name).name, name);
    EXPECT_TRUE(validate(recordingConfig(noiseLevel(name), 1)).empty());
    EXPECT_EQ(oldNoiseLevelWarning(name), std::nullopt);
    EXPECT_NE(noiseLevelHelp().find(name + " ("), std::string::npos);
  }
  try {
    noiseLevel("Low");
    FAIL() << "names are in lower case";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "'Low' is no noise level; the levels are none, low, moderate, realistic, hard");
  }
}

TEST(NoiseLevel, ModerateIsKnownByItsOldName) {
  EXPECT_EQ(noiseLevel("ideal").name, "moderate");
  EXPECT_EQ(
      oldNoiseLevelWarning("ideal"),
      "the noise level ideal is now called moderate; rename it, the next release does not know "
      "the old name");
  EXPECT_THROW(noiseLevel(""), InputError);
}

TEST(NoiseLevel, ShippedFilesNameEveryLevel) {
  // The levels as one list, since a word such as "low" also stands in other words.
  const std::vector<std::string> names = noiseLevelNames();
  std::string list = names.front();
  for (std::size_t i = 1; i + 1 < names.size(); ++i) {
    list += ", " + names[i];
  }
  for (const char* file : {"/config/simulator.yaml", "/config/bench.yaml", "/launch/demo.launch"}) {
    const std::string text = readFile(std::string(SFW_SOURCE_DIR) + file);
    EXPECT_TRUE(text.find(list + ", " + names.back()) != std::string::npos ||
                text.find(list + " or " + names.back()) != std::string::npos)
        << list << " in " << file;
  }
}

}  // namespace
}  // namespace sfw
