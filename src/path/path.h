#pragma once

#include <cstdint>

#include "structure_from_wifi/types.h"

namespace sfw {

/// A pose of the path for display.
struct PathPose {
  std::int64_t stamp_ns = 0;
  Position antenna_in_map = Position::Zero();  ///< [m]
  int walls = kNothingHeard;                   ///< fewest walls to any access point heard here

  static constexpr int kNothingHeard = -1;
};

}  // namespace sfw
