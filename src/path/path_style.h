#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// How a robot moves: along walls, from place to place, or roaming about wherever it is.
enum class DrivingStyle { kAlongWalls, kPatrol, kStroll };
constexpr std::size_t kDrivingStyles = 3;

/// As in files of models and in reports.
constexpr std::array<const char*, kDrivingStyles> kDrivingStyleNames{"along_walls", "patrol",
                                                                     "stroll"};

/// One figure for each style, in the order of DrivingStyle.
using StyleShares = std::array<double, kDrivingStyles>;

/// How a robot drives, in figures that tell the styles apart.
struct PathStyle {
  double rim_share = 0.0;   ///< of its cells within 0.15 m of the rim of what it encloses
  double axis_share = 0.0;  ///< mean cosine of four times its heading in the building frame
  double winding = 0.0;     ///< mean of (1 - cosine) / 2 of its turns every 0.3 m
};

/// Reads the style off a path.
/// @param path      the cells that it crosses, building frame
/// @param enclosed  depth in the area that it encloses, positive inside [m]
/// @param driven    positions [m] in the order driven, building frame; not empty
/// @param max_gap   successive positions farther apart are not joined [m]
PathStyle styleOf(const Mask& path, const Grid<float>& enclosed,
                  const std::vector<Position>& driven, double max_gap);

/// How well the path fits the building's axes at each cell that it crosses: the mean cosine of four
/// times its heading over 0.75 m to both sides; 1 along an axis, -1 midway, 0 where it winds.
Grid<float> axisAlignment(const GridGeometry& geometry, const std::vector<Position>& driven,
                          double max_gap);

}  // namespace sfw
