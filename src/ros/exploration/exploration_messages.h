#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <std_msgs/Header.h>
#include <structure_from_wifi/AccessPoints.h>
#include <structure_from_wifi/Walls.h>
#include <visualization_msgs/MarkerArray.h>

#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/exploration.h"

namespace sfw {

/// The newest messages of a mapper that an exploration needs.
struct MapMessages {
  nav_msgs::OccupancyGrid::ConstPtr map;
  nav_msgs::OccupancyGrid::ConstPtr probability;
  structure_from_wifi::Walls::ConstPtr walls;                 ///< may be missing
  structure_from_wifi::AccessPoints::ConstPtr access_points;  ///< may be missing
};

/// What is wrong with a grid, in words; empty if nothing is.
/// @param map_frame  in which it must lie
std::string problemOf(const nav_msgs::OccupancyGrid& grid, const std::string& map_frame);

/// The view of a map; nothing until map and probabilities of the same cells are there.
std::optional<ExplorationView> viewOf(const MapMessages& messages);

/// Draws the goals, best first, and the way to the goal that the robot drives to.
/// @param goal  of the present drive; may be absent
visualization_msgs::MarkerArray toMarkers(const std::vector<ExplorationGoal>& goals,
                                          const std::optional<ExplorationGoal>& goal,
                                          const std_msgs::Header& header);

}  // namespace sfw
