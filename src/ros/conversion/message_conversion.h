#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/TransformStamped.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <octomap_msgs/Octomap.h>
#include <std_msgs/Header.h>
#include <structure_from_wifi/AccessPoints.h>
#include <structure_from_wifi/Walls.h>

#include <string>

#include "structure_from_wifi/config.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/snapshot.h"

namespace octomap {
class OcTree;
}

namespace sfw {

/// A point at a height [m].
geometry_msgs::Point toPoint(const Position& position, double z);

/// The transform of a child frame at a position [m] and heading in its parent frame's plane.
geometry_msgs::TransformStamped toPlanarTransform(const ros::Time& stamp, const std::string& parent,
                                                  const std::string& child,
                                                  const Position& position, double yaw_rad);

/// The extent of a grid, unrotated.
nav_msgs::MapMetaData toMetaData(const GridGeometry& geometry, const ros::Time& load_time);

/// A grid of -1, 0 and 100 only, which costmap_2d's static layer and amcl read without loss.
nav_msgs::OccupancyGrid toTrinaryGrid(const BeliefMap& belief, const std_msgs::Header& header);
nav_msgs::OccupancyGrid toTrinaryGrid(const Grid<CellState>& states,
                                      const std_msgs::Header& header);

/// Whether two grids cover the same cells.
bool haveSameGeometry(const nav_msgs::MapMetaData& a, const nav_msgs::MapMetaData& b);

/// The smallest rectangle that contains every change between two grids of the same geometry; one
/// cell if nothing changed. It always lies inside the grid.
map_msgs::OccupancyGridUpdate toUpdate(const nav_msgs::OccupancyGrid& before,
                                       const nav_msgs::OccupancyGrid& after);

/// The probability of being occupied in percent, -1 in unknown cells.
nav_msgs::OccupancyGrid toProbabilityGrid(const BeliefMap& belief, const std_msgs::Header& header);

/// The result of planningCosts, whose values are those of the message.
nav_msgs::OccupancyGrid toCostGrid(const Grid<std::int8_t>& costs, const std_msgs::Header& header);

/// Losses of walls by the radio alone: 50 a dB, so 100 stands for 2 dB and more.
nav_msgs::OccupancyGrid toWallLossGrid(const Grid<float>& wall_loss_db,
                                       const std_msgs::Header& header);

/// The walls between passes of the robot, on the floor.
structure_from_wifi::Walls toWalls(const Snapshot& snapshot, const std_msgs::Header& header);

/// The poses of the path, each with its own stamp and without heading.
nav_msgs::Path toPath(const Snapshot& snapshot, const std_msgs::Header& header);

/// The access points in the order of the table, with estimates and checks. One without position has
/// NaN as x and y.
structure_from_wifi::AccessPoints toAccessPoints(const Snapshot& snapshot,
                                                 const DataFindings& findings,
                                                 const std_msgs::Header& header);

/// The tree as occupied, free and unknown voxels, or with all log-odds.
octomap_msgs::Octomap toBinaryOctomap(const octomap::OcTree& tree, const std_msgs::Header& header);
octomap_msgs::Octomap toFullOctomap(const octomap::OcTree& tree, const std_msgs::Header& header);

}  // namespace sfw
