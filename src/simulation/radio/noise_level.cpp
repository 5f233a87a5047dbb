#include "simulation/radio/noise_level.h"

#include <algorithm>

#include "base/old_name.h"
#include "base/random.h"
#include "base/random_streams.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// The values drawn from a level's ranges. Each has its own random number.
enum class Draw : std::uint64_t { kExponent, kWallLoss, kRegistrationError, kClearance };

double drawn(const Range& range, std::int64_t seed, Draw draw) {
  return Random(seed, streamOf(Purpose::kLevel), static_cast<std::uint64_t>(draw))
      .uniform(range.low, range.high);
}

}  // namespace

NoiseLevel noiseLevel(std::string_view name) {
  for (const NoiseLevel& level : kNoiseLevels) {
    if (name == level.name || (!level.old_name.empty() && name == level.old_name)) {
      return level;
    }
  }
  std::string names;
  for (const NoiseLevel& level : kNoiseLevels) {
    names += (names.empty() ? "" : ", ") + std::string(level.name);
  }
  throw InputError("'" + std::string(name) + "' is no noise level; the levels are " + names);
}

std::vector<std::string> noiseLevelNames() {
  std::vector<std::string> names;
  for (const NoiseLevel& level : kNoiseLevels) {
    names.emplace_back(level.name);
  }
  return names;
}

std::string noiseLevelHelp() {
  std::string text;
  for (const NoiseLevel& level : kNoiseLevels) {
    text += (text.empty() ? "" : ", ") + std::string(level.name) + " (" +
            std::string(level.description) + ")";
  }
  return text;
}

std::optional<std::string> oldNoiseLevelWarning(std::string_view name) {
  for (const NoiseLevel& level : kNoiseLevels) {
    if (!level.old_name.empty() && name == level.old_name) {
      return "the noise level " + oldNameWarning(std::string(name), std::string(level.name));
    }
  }
  return std::nullopt;
}

RadioModel::Config radioConfig(const NoiseLevel& level, std::int64_t seed) {
  constexpr double kOuterToInterior = 2.0;
  RadioModel::Config radio;
  radio.seed = seed;
  radio.exponent = drawn(level.exponent, seed, Draw::kExponent);
  radio.interior_wall_loss_db = drawn(level.wall_loss_db, seed, Draw::kWallLoss);
  radio.interior_wall_variation_db = level.wall_variation_db;
  radio.outer_wall_loss_db = kOuterToInterior * radio.interior_wall_loss_db;
  radio.outer_wall_variation_db = kOuterToInterior * radio.interior_wall_variation_db;
  radio.max_obstacle_loss_db = level.max_obstacle_loss_db;
  radio.shadowing_db = level.shadowing_db;
  radio.shadowing_distance_m = level.shadowing_distance_m;
  radio.sample_noise_db = level.sample_noise_db;
  radio.access_point_pattern_db = level.antenna_pattern_db;
  radio.robot_pattern_db = level.antenna_pattern_db;
  radio.max_furniture_loss_db = level.max_furniture_loss_db;
  radio.rssi_step_db = level.rssi_step_db;
  return radio;
}

RecordingConfig recordingConfig(const NoiseLevel& level, std::int64_t seed) {
  RecordingConfig config;
  config.radio = radioConfig(level, seed);
  config.registration_error_m = drawn(level.registration_error_m, seed, Draw::kRegistrationError);
  return config;
}

double wallClearance(const NoiseLevel& level, std::int64_t seed) {
  return drawn(level.clearance_m, seed, Draw::kClearance);
}

}  // namespace sfw
