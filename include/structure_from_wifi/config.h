#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "structure_from_wifi/export.h"

namespace sfw {

/// Every setting of the mapper, with its default. config/mapping.yaml explains each one.
struct Config {
  /// The method that infers walls. "tomography" uses all readings together and fuses them with the
  /// path. "k_visibility" uses wall counts, as in the paper.
  std::string method = "tomography";

  /// Extent and resolution of the map.
  struct Map {
    double resolution_m = 0.05;           ///< edge of a cell
    double margin_m = 1.0;                ///< kept around poses and access points
    double growth_step_m = 8.0;           ///< the map's edges lie on multiples of this
    std::int64_t max_cells = 16000000;    ///< a larger map is refused
    std::int64_t max_readings = 5000000;  ///< more are refused
  } map;                                  ///< settings map/*

  /// The robot on its path; both methods use it.
  struct Path {
    double footprint_radius_m = 0.15;  ///< of the robot
    double max_gap_m = 1.0;            ///< poses farther apart are not joined into a path
  } path;                              ///< settings path/*

  /// Method "k_visibility": from signal strength to wall counts, and from these to cells.
  struct KVisibility {
    std::string filter = "median";    ///< of the sliding window: "median" or "mean"
    std::int64_t window = 5;          ///< readings of one access point, odd
    double path_loss_exponent = 1.2;  ///< loss by distance removed before counting; 0: none
    std::int64_t wall_count = 0;      ///< largest wall count K; 0: chosen from the data
    std::int64_t max_wall_count = 4;  ///< largest K that the data may choose
    double min_wall_loss_db = 5.0;    ///< least distance of neighbouring centroids
    double wall_thickness_m = 0.10;   ///< of each wall that a count finds
    double wall_prior = 0.02;         ///< share of the area that is wall before any reading
  } k_visibility;                     ///< settings k_visibility/*

  /// Method "tomography": from all readings to the losses of walls.
  struct Tomography {
    double bin_size_m = 0.2;              ///< readings of one access point this close are averaged
    double max_total_wall_loss_db = 0.0;  ///< limit of the sum of losses; 0: none
    double l1_weight = 0.03;              ///< weight of the sum of all losses: fewer walls
    double smoothness_weight = 8.0;       ///< weight of changes along a wall: longer walls
    double nugget_db = 2.0;               ///< standard deviation of a bin that no wall explains
    std::int64_t wall_directions = 2;     ///< that walls may have: 2, 4, 6 or 8
    std::int64_t ensemble_size = 8;       ///< solutions that are averaged
  } tomography;                           ///< settings tomography/*

  /// The thresholds between free, occupied and unknown.
  struct Belief {
    double free_threshold = 0.2;       ///< free below this probability of being occupied
    double occupied_threshold = 0.65;  ///< occupied above it
    std::string model;                 ///< file of `sfw fit` for tomography; empty: as shipped
    std::string walls = "network";     ///< beside the way of the robot: "network" or "none"
    std::string rim = "unknown";       ///< state of the free area's border: or "occupied"
  } belief;                            ///< settings belief/*

  /// Extrusion into OctoMap.
  struct Octomap {
    double wall_height_m = 2.5;   ///< occupied cells reach from the floor to here
    double robot_height_m = 0.5;  ///< free cells reach from the floor to here
  } octomap;                      ///< settings octomap/*
};

/// Calls `visit(name, member)` for each setting in the order of config/mapping.yaml.
///
/// The name is the path of the ROS parameter and of the YAML key ("map/resolution"); the member is
/// a reference to double, std::int64_t or std::string. No other list exists: readers, the report
/// and the tests all use this one.
template <class AnyConfig, class Visitor>
void forEachSetting(AnyConfig& config, Visitor&& visit) {
  visit("method", config.method);
  visit("map/resolution", config.map.resolution_m);
  visit("map/margin", config.map.margin_m);
  visit("map/growth_step", config.map.growth_step_m);
  visit("map/max_cells", config.map.max_cells);
  visit("map/max_readings", config.map.max_readings);
  visit("path/footprint_radius", config.path.footprint_radius_m);
  visit("path/max_gap", config.path.max_gap_m);
  visit("k_visibility/filter", config.k_visibility.filter);
  visit("k_visibility/window", config.k_visibility.window);
  visit("k_visibility/path_loss_exponent", config.k_visibility.path_loss_exponent);
  visit("k_visibility/wall_count", config.k_visibility.wall_count);
  visit("k_visibility/max_wall_count", config.k_visibility.max_wall_count);
  visit("k_visibility/min_wall_loss", config.k_visibility.min_wall_loss_db);
  visit("k_visibility/wall_thickness", config.k_visibility.wall_thickness_m);
  visit("k_visibility/wall_prior", config.k_visibility.wall_prior);
  visit("tomography/bin_size", config.tomography.bin_size_m);
  visit("tomography/max_total_wall_loss", config.tomography.max_total_wall_loss_db);
  visit("tomography/l1_weight", config.tomography.l1_weight);
  visit("tomography/smoothness_weight", config.tomography.smoothness_weight);
  visit("tomography/nugget", config.tomography.nugget_db);
  visit("tomography/wall_directions", config.tomography.wall_directions);
  visit("tomography/ensemble_size", config.tomography.ensemble_size);
  visit("belief/free_threshold", config.belief.free_threshold);
  visit("belief/occupied_threshold", config.belief.occupied_threshold);
  visit("belief/model", config.belief.model);
  visit("belief/walls", config.belief.walls);
  visit("belief/rim", config.belief.rim);
  visit("octomap/wall_height", config.octomap.wall_height_m);
  visit("octomap/robot_height", config.octomap.robot_height_m);
}

/// Every problem of a configuration, one sentence each that starts with the setting's name.
/// Empty if it can be used. Settings are checked together, so crossed thresholds are found too.
SFW_EXPORT std::vector<std::string> validate(const Config& config);

}  // namespace sfw
