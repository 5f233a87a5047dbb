#pragma once

#include <cstdint>

#include "simulation/radio/noise_level.h"
#include "training/training_drive.h"

namespace sfw {

/// Disturbs a simulated drive in ways of real recordings, so that what is trained does not rely on
/// exact data:
///
/// - positions of access points are wrong by up to half a metre,
/// - single readings are up to 10 dB too weak, and all readings have more noise,
/// - receivers average signals over up to 60 readings,
/// - the signals of a few drives have one more field of slow variation,
/// - the signals of a few drives are shifted along the path, so the radio says nothing about walls.
///
/// @param noise  level of the drive; with `none` and `low`, only positions and averages, seldom
/// @param seed   of the drive
void disturb(TrainingDrive& drive, const NoiseLevel& noise, std::int64_t seed);

}  // namespace sfw
