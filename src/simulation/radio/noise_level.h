#pragma once

#include <cstdint>
#include <string_view>

#include "simulation/simulated_recording.h"

namespace sfw {

/// How far a simulation is from the textbook, with fixed figures (standard deviations in dB):
///
/// | level       | shadowing        | sample | wall to wall | losses of walls              |
/// |-------------|------------------|--------|--------------|------------------------------|
/// | `none`      | 0                | 0      | 0            | add up                       |
/// | `low`       | 1 over 1.5 m     | 1      | 0.5          | add up                       |
/// | `ideal`     | 2.5 over 1.5 m   | 2      | 1            | add up                       |
/// | `realistic` | 3.7 over 0.6 m   | 3      | 1            | saturate at 15 dB            |
/// | `hard`      | 5 over 0.6 m     | 4      | 1            | saturate at 10 dB            |
///
/// The first three have exponent 2 and 6.1 dB a wall (measured in a furnished flat). The last two
/// draw from the seed, once for a recording: exponent 1.5 to 2.2, 6 to 11 dB a wall, registration
/// error .03 to .18 m over 3 m; and they have antenna patterns of 2 dB each for access point and
/// robot, and furniture of 0 to 5 dB, a piece in each 9 m2. Outer walls lose and vary twice as much
/// as interior ones on every level. Signals come in steps of 1 dB except with `none`, where they
/// are not rounded.
enum class NoiseLevel : std::uint8_t { kNone, kLow, kModerate, kRealistic, kHard };

/// @param name  as in the table
/// @throw InputError naming the text and all levels.
NoiseLevel parseNoiseLevel(std::string_view name);

const char* nameOf(NoiseLevel level);

/// A level's recording: its drive and its radio, whose seed is `seed`; what the table does not
/// mention has its default.
RecordingConfig levelConfig(NoiseLevel level, std::int64_t seed);

/// Only the radio of levelConfig.
RadioModel::Config levelRadio(NoiseLevel level, std::int64_t seed);

/// Clearance at which a path along walls follows them: .10 to .42 m from the seed on the levels
/// `realistic` and `hard`, else .30 m; measured from the robot's rim.
double levelClearance(NoiseLevel level, std::int64_t seed);

}  // namespace sfw
