#pragma once

#include <vector>

#include "localization/scan.h"

namespace sfw {

/// How a robot moves, as far as its velocity is an Ornstein-Uhlenbeck process.
struct Motion {
  double speed = 0.3;            ///< root mean square [m/s], positive
  double velocity_time_s = 5.0;  ///< in which a velocity is forgotten, positive
};

/// Measures the motion on a path, on steps of 2 to 20 s.
/// @param scans by time
/// @return the defaults where there is no such step. A robot that stood still has 0.05 m/s.
Motion motionOf(const std::vector<Scan>& scans);

}  // namespace sfw
