#pragma once

#include <vector>

#include "localization/scan.h"

namespace sfw {

/// How a robot moves: it keeps a velocity for a random time, then takes another one.
struct Motion {
  double speed = 0.3;                ///< root mean square [m/s], positive
  double velocity_time_s = 5.0;      ///< mean time for which a velocity is kept, positive
  std::vector<Position> velocities;  ///< met on the path [m/s]; empty: none is known
};

/// Measures the motion on a path, on steps of 2 to 20 s.
/// @param scans by time
/// @return the defaults where there is no such step. A robot that stood still has 0.05 m/s.
Motion motionOf(const std::vector<Scan>& scans);

}  // namespace sfw
