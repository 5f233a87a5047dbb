#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Styles of driving: along walls, from place to place, or roaming around.
enum class DrivingStyle { kAlongWalls, kPatrol, kStroll };
constexpr std::size_t kDrivingStyles = 3;

/// Names of the styles in model files and in reports.
constexpr std::array<const char*, kDrivingStyles> kDrivingStyleNames{"along_walls", "patrol",
                                                                     "stroll"};

/// One share for each style, in the order of DrivingStyle.
using StyleShares = std::array<double, kDrivingStyles>;

/// Three measures of a path that separate the driving styles.
struct PathStyle {
  double rim_share = 0.0;   ///< share of its cells within 0.15 m of the rim of the enclosed area
  double axis_share = 0.0;  ///< mean cosine of four times its heading in the building frame
  double winding = 0.0;     ///< mean of (1 - cosine) / 2 of its turns every 0.3 m
};

/// Measures the style of a path.
/// @param path              the cells that it crosses, building frame
/// @param enclosed_depth_m  depth in the area that the path encloses, positive inside
/// @param driven            positions [m] in the order driven, building frame; not empty
/// @param max_gap_m         successive positions farther apart are not joined
PathStyle measurePathStyle(const Mask& path, const Grid<float>& enclosed_depth_m,
                           const std::vector<Position>& driven, double max_gap_m);

/// Measures how well the path fits the building's axes at each cell that it crosses.
///
/// The value is the mean cosine of four times the heading over 0.75 m to both sides. It is 1 along
/// an axis, -1 midway between the axes, near 0 where the path winds, and 0 off the path.
/// @param driven,max_gap_m  as for measurePathStyle
Grid<float> axisAlignment(const GridGeometry& geometry, const std::vector<Position>& driven,
                          double max_gap_m);

}  // namespace sfw
