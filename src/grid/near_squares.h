#pragma once

#include <cstdint>

#include "grid/mask.h"

namespace sfw {

/// The largest reach of nearSquares [cells]: its squares fit 16 bits.
constexpr std::int64_t kFarthestNear = 126;

/// The value of nearSquares beyond its reach.
constexpr std::int16_t kBeyondReach = INT16_MAX;

/// Squares of the distances of distanceTransform, as far as they are shorter than `reach` + 1;
/// kBeyondReach everywhere else.
///
/// For short reaches it takes a fifth of the time, because the processor compares many cells at
/// once. O(cells x reach).
/// @param reach  [cells], in 0..kFarthestNear
Grid<std::int16_t> nearSquares(const Mask& mask, std::int64_t reach);

}  // namespace sfw
