#pragma once

#include <optional>

#include "base/random.h"
#include "simulation/radio/noise_level.h"
#include "training/training_drive.h"

namespace sfw {

/// Simulates a survey: the robot or a person stops at the places of a lattice and measures there.
///
/// Places are 0.5 to 1.7 m apart. The nearest place without a visit comes next. Each place gets one
/// to four readings of each access point at its first visit. There are 1 to 40 access points, some
/// with a second band.
/// @param plan  of the building; it is cut and furnished at random
/// @param seed  of access points and radio
/// @return nothing if fewer than 30 places can be visited.
std::optional<TrainingDrive> makeSurvey(const FloorPlan& plan, const NoiseLevel& noise,
                                        std::int64_t seed, Random& random);

}  // namespace sfw
