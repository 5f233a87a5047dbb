#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "structure_from_wifi/export.h"

namespace sfw {

/// Every setting of the package, with its default. config/mapping.yaml explains each one.
struct Config {
  /// How walls are inferred: "tomography" from all readings together, fused with the path, or
  /// "k_visibility" from wall counts, as in the paper.
  std::string method = "tomography";

  /// Extent and grain of the map.
  struct Map {
    double resolution = 0.05;           ///< edge of a cell [m]
    double margin = 1.0;                ///< kept around poses and access points [m]
    double growth_step = 8.0;           ///< the map's edges lie on multiples of this [m]
    std::int64_t max_cells = 16000000;  ///< a larger map is refused
    std::int64_t max_readings = 5000000;
  } map;

  /// From signal strength to wall counts.
  struct Rssi {
    std::string filter = "median";    ///< of the sliding window: "median" or "mean"
    std::int64_t window = 5;          ///< readings of one access point, odd
    double path_loss_exponent = 1.2;  ///< loss by distance taken off before counting; 0: none
    std::int64_t walls = 0;           ///< largest wall count K; 0 lets the data choose
    std::int64_t max_walls = 4;       ///< largest K that the data may choose
    double min_wall_loss = 5.0;       ///< least distance of neighbouring centroids [dB]
  } rssi;

  /// From all readings to the losses of walls.
  struct Tomography {
    double bin = 0.2;             ///< readings of one access point this close count as one [m]
    double saturation = 0.0;      ///< losses of all walls stay below [dB]; 0: they add up
    double sparsity = 0.03;       ///< weight of the sum of all losses: fewer walls
    double straightness = 8.0;    ///< weight of changes along a wall: longer walls
    double unexplained = 2.0;     ///< standard deviation of a bin that nothing explains [dB]
    std::int64_t directions = 2;  ///< that walls may have: 2, 4, 6 or 8
    std::int64_t members = 8;     ///< solutions that are averaged
  } tomography;

  /// From wall counts to cells.
  struct Inference {
    double footprint_radius = 0.15;  ///< of the robot [m]
    double max_gap = 1.0;            ///< poses farther apart are not joined into a path [m]
    double wall_thickness = 0.10;    ///< [m]
    double wall_density = 0.02;      ///< share of the area that is wall, before anything is heard
  } inference;

  /// From probability to free, occupied and unknown.
  struct Belief {
    double free_threshold = 0.2;       ///< free below this probability of being occupied
    double occupied_threshold = 0.65;  ///< occupied above it
    std::string model;                 ///< file of `sfw fit` for tomography; empty: as shipped
  } belief;

  /// Extrusion into OctoMap.
  struct Octomap {
    double wall_height = 2.5;   ///< occupied cells reach from the floor to here [m]
    double robot_height = 0.5;  ///< free cells reach from the floor to here [m]
  } octomap;

  /// What only the ROS side uses.
  struct Ros {
    std::string map_frame = "map";
    std::string antenna_frame = "base_link";
    std::string odom_frame = "odom";  ///< readings follow it when the past is corrected
    double jump_distance = 0.1;       ///< a larger correction of odom_frame moves the past [m]
    double jump_angle = 0.05;         ///< likewise [rad]
    double publish_rate = 1.0;        ///< most map updates a second [Hz]
    double transform_timeout = 5.0;   ///< a scan waits this long for its transform [s]
    double tf_cache = 30.0;           ///< transforms are kept this long [s]
    std::int64_t max_waiting = 2000;  ///< scans that may wait for a transform
    std::string save_directory = "~/.ros/structure_from_wifi";
  } ros;
};

/// Calls `visit(name, member)` for each setting in the order of config/mapping.yaml.
///
/// The name is the path of the ROS parameter and of the YAML key ("map/resolution"); the member is
/// a reference to double, std::int64_t or std::string. This list is the only one: readers, the
/// report and the tests are all made from it.
template <class AnyConfig, class Visitor>
void forEachSetting(AnyConfig& config, Visitor&& visit) {
  visit("method", config.method);
  visit("map/resolution", config.map.resolution);
  visit("map/margin", config.map.margin);
  visit("map/growth_step", config.map.growth_step);
  visit("map/max_cells", config.map.max_cells);
  visit("map/max_readings", config.map.max_readings);
  visit("rssi/filter", config.rssi.filter);
  visit("rssi/window", config.rssi.window);
  visit("rssi/path_loss_exponent", config.rssi.path_loss_exponent);
  visit("rssi/walls", config.rssi.walls);
  visit("rssi/max_walls", config.rssi.max_walls);
  visit("rssi/min_wall_loss", config.rssi.min_wall_loss);
  visit("tomography/bin", config.tomography.bin);
  visit("tomography/saturation", config.tomography.saturation);
  visit("tomography/sparsity", config.tomography.sparsity);
  visit("tomography/straightness", config.tomography.straightness);
  visit("tomography/unexplained", config.tomography.unexplained);
  visit("tomography/directions", config.tomography.directions);
  visit("tomography/members", config.tomography.members);
  visit("inference/footprint_radius", config.inference.footprint_radius);
  visit("inference/max_gap", config.inference.max_gap);
  visit("inference/wall_thickness", config.inference.wall_thickness);
  visit("inference/wall_density", config.inference.wall_density);
  visit("belief/free_threshold", config.belief.free_threshold);
  visit("belief/occupied_threshold", config.belief.occupied_threshold);
  visit("belief/model", config.belief.model);
  visit("octomap/wall_height", config.octomap.wall_height);
  visit("octomap/robot_height", config.octomap.robot_height);
  visit("ros/map_frame", config.ros.map_frame);
  visit("ros/antenna_frame", config.ros.antenna_frame);
  visit("ros/odom_frame", config.ros.odom_frame);
  visit("ros/jump_distance", config.ros.jump_distance);
  visit("ros/jump_angle", config.ros.jump_angle);
  visit("ros/publish_rate", config.ros.publish_rate);
  visit("ros/transform_timeout", config.ros.transform_timeout);
  visit("ros/tf_cache", config.ros.tf_cache);
  visit("ros/max_waiting", config.ros.max_waiting);
  visit("ros/save_directory", config.ros.save_directory);
}

/// Every problem of a configuration, one sentence each that starts with the setting's name.
/// Empty if it can be used. Settings are checked together, so crossed thresholds are found too.
SFW_EXPORT std::vector<std::string> validate(const Config& config);

}  // namespace sfw
