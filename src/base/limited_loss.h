#pragma once

#include <cmath>

namespace sfw {

/// Total loss of walls in series [dB]. It approaches a limit, because signals also propagate around
/// walls.
/// @param sum_db    of the walls' own losses
/// @param limit_db  0 or infinity: losses add up
inline double limitedLoss(double sum_db, double limit_db) {
  const bool limited = limit_db > 0.0 && std::isfinite(limit_db);
  return limited ? limit_db * -std::expm1(-sum_db / limit_db) : sum_db;
}

}  // namespace sfw
