#pragma once

#include <cmath>
#include <string>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The error of a path that needs more cells than map/max_cells.
inline std::string tooLargeText(const Box& path, const Config::Map& config) {
  const Position size = path.sizes();
  return "the path covers " + std::to_string(std::lround(size.x())) + " x " +
         std::to_string(std::lround(size.y())) +
         " m, more than map/max_cells allows; leave out wrong poses, or raise "
         "map/max_cells (" +
         std::to_string(config.max_cells) + ") or map/resolution";
}

}  // namespace sfw
