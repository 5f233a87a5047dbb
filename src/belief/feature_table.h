#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace sfw {

/// The quantities behind the features of one cell. Distances and depths lie in the building frame.
/// The source is the cell of the path at which the cheapest way to this cell begins.
struct CellInputs {
  /// Depths [m] inside the path closed with discs or squares of three sizes; negative outside.
  struct Depths {
    float small = 0.0F;   ///< closed with 0.6 m
    float middle = 0.0F;  ///< closed with 1.2 m, holes filled
    float large = 0.0F;   ///< closed with 2.4 m, holes filled
  };

  float path_distance_m = 0.0F;
  Depths disc_depth_m;
  Depths square_depth_m;
  float rays = 0.0F;                ///< number of rays through the cell
  float access_point_share = 0.0F;  ///< share of the access points with a ray through the cell
  float access_point_distance_m = 0.0F;
  float line_of_sight = 0.0F;  ///< 1 where a ray without loss passes, towards 0 with its loss
  float wall_strength = 0.0F;  ///< of the wall here, 0 to 1
  float wall_beside = 0.0F;    ///< mean strength of walls within 0.2 m, 0 to 1
  float way_around = 0.0F;     ///< extra cost of the cheapest way from the path, 0 to 1
  /// Distances to the footprint along the axes, in shares of 3 m: the axis with the nearest one
  /// first, and the nearer side of each axis first.
  std::array<float, 4> axis_distances{};
  float small_coverage = 0.0F;  ///< share of cells within 0.6 m that the footprint covers
  float large_coverage = 0.0F;  ///< the same within 1.5 m
  float source_alignment = 0.0F;
  Depths source_depth_m;
  float explained_variance = 0.0F;  ///< of the signals, by walls: one value for a drive
};

/// A feature of a cell: an input of the belief model, of order one.
struct CellFeature {
  const char* name;
  bool uses_radio;  ///< it depends on signal strength; all others are geometry of path and rays
  float (*value)(const CellInputs& cell);
};

/// The excess of a value over a limit. It lets the model fit a line with a bend at the limit.
inline float over(float value, float limit) { return std::max(0.0F, value - limit); }

/// All features in the order of the vectors made of them; doc/method/belief.md explains each.
inline constexpr CellFeature kCellFeatureTable[] = {
    {"path_close", false, [](const CellInputs& c) { return std::exp(-c.path_distance_m / 0.1F); }},
    {"path_distance", false, [](const CellInputs& c) { return c.path_distance_m; }},
    {"path_near", false, [](const CellInputs& c) { return std::exp(-c.path_distance_m / 0.4F); }},
    {"depth_disc_0.6", false, [](const CellInputs& c) { return c.disc_depth_m.small; }},
    {"depth_disc_1.2", false, [](const CellInputs& c) { return c.disc_depth_m.middle; }},
    {"depth_disc_2.4", false, [](const CellInputs& c) { return c.disc_depth_m.large; }},
    {"depth_square_0.6", false, [](const CellInputs& c) { return c.square_depth_m.small; }},
    {"depth_square_1.2", false, [](const CellInputs& c) { return c.square_depth_m.middle; }},
    {"depth_square_2.4", false, [](const CellInputs& c) { return c.square_depth_m.large; }},
    {"rays", false,
     [](const CellInputs& c) { return std::min(std::log2(1.0F + c.rays), 6.0F) / 6.0F; }},
    {"access_points", false, [](const CellInputs& c) { return c.access_point_share; }},
    {"line_of_sight", true, [](const CellInputs& c) { return c.line_of_sight; }},
    {"access_point_near", false,
     [](const CellInputs& c) { return std::exp(-c.access_point_distance_m); }},
    {"wall_strength", true, [](const CellInputs& c) { return c.wall_strength; }},
    {"wall_beside", true, [](const CellInputs& c) { return c.wall_beside; }},
    {"way_around", true, [](const CellInputs& c) { return c.way_around; }},
    {"nearest_along", false, [](const CellInputs& c) { return c.axis_distances[0]; }},
    {"opposite_along", false, [](const CellInputs& c) { return c.axis_distances[1]; }},
    {"nearest_across", false, [](const CellInputs& c) { return c.axis_distances[2]; }},
    {"opposite_across", false, [](const CellInputs& c) { return c.axis_distances[3]; }},
    {"coverage_0.6", false, [](const CellInputs& c) { return c.small_coverage; }},
    {"coverage_1.5", false, [](const CellInputs& c) { return c.large_coverage; }},
    {"source_alignment", false, [](const CellInputs& c) { return c.source_alignment; }},
    {"source_depth_0.6", false, [](const CellInputs& c) { return c.source_depth_m.small; }},
    {"source_depth_1.2", false, [](const CellInputs& c) { return c.source_depth_m.middle; }},
    {"source_depth_2.4", false, [](const CellInputs& c) { return c.source_depth_m.large; }},
    {"explained", true, [](const CellInputs& c) { return c.explained_variance; }},
    {"explained_line_of_sight", true,
     [](const CellInputs& c) { return c.explained_variance * c.line_of_sight; }},
    {"explained_wall_strength", true,
     [](const CellInputs& c) { return c.explained_variance * c.wall_strength; }},
    {"explained_wall_beside", true,
     [](const CellInputs& c) { return c.explained_variance * c.wall_beside; }},
    {"explained_way_around", true,
     [](const CellInputs& c) { return c.explained_variance * c.way_around; }},
    {"line_of_sight_over_0.1", true,
     [](const CellInputs& c) { return over(c.line_of_sight, 0.1F); }},
    {"line_of_sight_over_0.4", true,
     [](const CellInputs& c) { return over(c.line_of_sight, 0.4F); }},
    {"wall_strength_over_0.1", true,
     [](const CellInputs& c) { return over(c.wall_strength, 0.1F); }},
    {"wall_beside_over_0.02", true, [](const CellInputs& c) { return over(c.wall_beside, 0.02F); }},
    {"wall_beside_over_0.1", true, [](const CellInputs& c) { return over(c.wall_beside, 0.1F); }},
    {"way_around_over_0.1", true, [](const CellInputs& c) { return over(c.way_around, 0.1F); }},
    {"way_around_over_0.25", true, [](const CellInputs& c) { return over(c.way_around, 0.25F); }},
};

constexpr std::size_t kCellFeatures = std::size(kCellFeatureTable);

/// The features of one cell, in the order of kCellFeatureTable.
using FeatureVector = std::array<float, kCellFeatures>;

}  // namespace sfw
