#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Whether a point lies in a polygon, by the even-odd rule. Points on the border may count either
/// way. O(corners).
bool contains(const std::vector<Position>& polygon, const Position& point);

}  // namespace sfw
