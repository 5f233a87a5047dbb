#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/simulated_recording.h"

namespace sfw {

/// The ends of a range; each recording draws a value from it. Equal ends fix the value.
struct Range {
  double low;
  double high;
};

/// A level of noise in simulations: one row of kNoiseLevels.
///
/// Standard deviations are those of RadioModel::Config. Outer walls lose and vary twice as much as
/// interior walls on every level.
struct NoiseLevel {
  std::string_view name;
  std::string_view description;  ///< for help texts
  std::string_view old_name;     ///< of the release before; empty: the name is the same
  double shadowing_db;           ///< standard deviation from place to place
  double shadowing_distance_m;
  double sample_noise_db;        ///< standard deviation at one place
  double wall_variation_db;      ///< standard deviation from wall to wall
  double max_obstacle_loss_db;   ///< at which the losses of walls saturate; 0: they add up
  double antenna_pattern_db;     ///< of access point and robot, each
  double max_furniture_loss_db;  ///< of a piece in each 9 m2; 0: no furniture
  double rssi_step_db;           ///< 0: not rounded
  Range exponent;                ///< of path loss
  Range wall_loss_db;            ///< of an interior wall
  Range registration_error_m;    ///< standard deviation on each axis
  Range clearance_m;             ///< between robot and walls on a route along the walls
};

/// Every noise level, from none to hard. The first three are a textbook's radio; the others imitate
/// real homes. Walls lose 6.1 dB as measured in a furnished flat, or a value from the range that
/// was measured in homes.
///
/// Columns: name, description, old name; shadowing and its distance, sample noise, wall variation,
/// maximum obstacle loss, antenna pattern, maximum furniture loss, RSSI step; ranges of exponent,
/// wall loss, registration error and clearance.
// clang-format off
inline constexpr NoiseLevel kNoiseLevels[] = {
    {"none",      "exact signals",                       "",      0.0, 1.5, 0.0, 0.0, 0.0,  0.0, 0.0, 0.0, {2.0, 2.0}, {6.1, 6.1},  {0.0, 0.0},   {0.30, 0.30}},
    {"low",       "textbook radio, little noise",        "",      1.0, 1.5, 1.0, 0.5, 0.0,  0.0, 0.0, 1.0, {2.0, 2.0}, {6.1, 6.1},  {0.0, 0.0},   {0.30, 0.30}},
    {"moderate",  "textbook radio, 2.5 dB of shadowing", "ideal", 2.5, 1.5, 2.0, 1.0, 0.0,  0.0, 0.0, 1.0, {2.0, 2.0}, {6.1, 6.1},  {0.0, 0.0},   {0.30, 0.30}},
    {"realistic", "like measured homes",                 "",      3.7, 0.6, 3.0, 1.0, 15.0, 2.0, 5.0, 1.0, {1.5, 2.2}, {6.0, 11.0}, {0.03, 0.18}, {0.10, 0.42}},
    {"hard",      "worse than measured homes",           "",      5.0, 0.6, 4.0, 1.0, 10.0, 2.0, 5.0, 1.0, {1.5, 2.2}, {6.0, 11.0}, {0.03, 0.18}, {0.10, 0.42}},
};
// clang-format on

/// @param name  of a row, or its old name
/// @throw InputError that names the text and all levels.
NoiseLevel noiseLevel(std::string_view name);

/// The names of all levels, in the order of the table.
std::vector<std::string> noiseLevelNames();

/// The names of all levels with their descriptions, for help texts.
std::string noiseLevelHelp();

/// A sentence for the user if a name is the old name of a level; otherwise nothing.
std::optional<std::string> oldNoiseLevelWarning(std::string_view name);

/// The settings of a recording on a level. Settings that a level does not have keep their defaults.
/// @param seed  of the recording; it also draws from the level's ranges
RecordingConfig recordingConfig(const NoiseLevel& level, std::int64_t seed);

/// The radio settings of recordingConfig alone.
RadioModel::Config radioConfig(const NoiseLevel& level, std::int64_t seed);

/// Clearance [m] between the robot's rim and the walls on a route along the walls.
double wallClearance(const NoiseLevel& level, std::int64_t seed);

}  // namespace sfw
