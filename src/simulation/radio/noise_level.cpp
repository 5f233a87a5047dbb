#include "simulation/radio/noise_level.h"

#include <array>
#include <string>

#include "base/random.h"
#include "base/random_streams.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr std::array<NoiseLevel, 5> kLevels{NoiseLevel::kNone, NoiseLevel::kLow,
                                            NoiseLevel::kModerate, NoiseLevel::kRealistic,
                                            NoiseLevel::kHard};

/// What each recording draws anew on the levels that imitate real homes.
struct Draws {
  double exponent;
  double wall_loss_db;
  double registration_error_m;
  double clearance_m;
};

Draws drawsOf(std::int64_t seed) {
  const auto between = [seed](double low, double high, std::uint64_t item) {
    return Random(seed, streamOf(Purpose::kLevel), item).uniform(low, high);
  };
  return {between(1.5, 2.2, 0), between(6.0, 11.0, 1), between(0.03, 0.18, 2),
          between(0.10, 0.42, 3)};
}

bool isLikeHomes(NoiseLevel level) {
  return level == NoiseLevel::kRealistic || level == NoiseLevel::kHard;
}

void setNoise(RadioModel::Config& radio, double shadowing, double sample, double wall_to_wall) {
  radio.shadowing_db = shadowing;
  radio.sample_noise_db = sample;
  radio.interior_wall_variation_db = wall_to_wall;
}

/// Levels of the textbook.
void setIdealWorld(RadioModel::Config& radio) {
  radio.exponent = 2.0;
  radio.interior_wall_loss_db = 6.1;
  radio.shadowing_distance_m = 1.5;
}

/// Levels that imitate real homes.
void setHome(RadioModel::Config& radio, std::int64_t seed) {
  const Draws draws = drawsOf(seed);
  radio.exponent = draws.exponent;
  radio.interior_wall_loss_db = draws.wall_loss_db;
  radio.shadowing_distance_m = 0.6;
  radio.access_point_pattern_db = 2.0;
  radio.robot_pattern_db = 2.0;
  radio.max_furniture_loss_db = 5.0;
}

}  // namespace

NoiseLevel parseNoiseLevel(std::string_view name) {
  std::string names;
  for (const NoiseLevel level : kLevels) {
    if (name == nameOf(level)) {
      return level;
    }
    names += (names.empty() ? "" : ", ") + std::string(nameOf(level));
  }
  throw InputError("'" + std::string(name) + "' is no noise level; there are " + names);
}

const char* nameOf(NoiseLevel level) {
  switch (level) {
    case NoiseLevel::kNone:
      return "none";
    case NoiseLevel::kLow:
      return "low";
    case NoiseLevel::kModerate:
      return "ideal";
    case NoiseLevel::kRealistic:
      return "realistic";
    case NoiseLevel::kHard:
      return "hard";
  }
  return "";
}

RadioModel::Config levelRadio(NoiseLevel level, std::int64_t seed) {
  constexpr double kOuterToInterior = 2.0;
  RadioModel::Config radio;
  radio.seed = seed;
  if (isLikeHomes(level)) {
    setHome(radio, seed);
  } else {
    setIdealWorld(radio);
  }
  switch (level) {
    case NoiseLevel::kNone:
      setNoise(radio, 0.0, 0.0, 0.0);
      radio.rssi_step_db = 0.0;
      break;
    case NoiseLevel::kLow:
      setNoise(radio, 1.0, 1.0, 0.5);
      break;
    case NoiseLevel::kModerate:
      setNoise(radio, 2.5, 2.0, 1.0);
      break;
    case NoiseLevel::kRealistic:
      setNoise(radio, 3.7, 3.0, 1.0);
      radio.max_obstacle_loss_db = 15.0;
      break;
    case NoiseLevel::kHard:
      setNoise(radio, 5.0, 4.0, 1.0);
      radio.max_obstacle_loss_db = 10.0;
      break;
  }
  radio.outer_wall_loss_db = kOuterToInterior * radio.interior_wall_loss_db;
  radio.outer_wall_variation_db = kOuterToInterior * radio.interior_wall_variation_db;
  return radio;
}

RecordingConfig levelConfig(NoiseLevel level, std::int64_t seed) {
  RecordingConfig config;
  config.radio = levelRadio(level, seed);
  if (isLikeHomes(level)) {
    config.registration_error_m = drawsOf(seed).registration_error_m;
    config.registration_distance_m = 3.0;
  }
  return config;
}

double levelClearance(NoiseLevel level, std::int64_t seed) {
  constexpr double kUsual = 0.30;
  return isLikeHomes(level) ? drawsOf(seed).clearance_m : kUsual;
}

}  // namespace sfw
