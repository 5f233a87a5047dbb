#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The density with which a route covers a building.
enum class RouteKind {
  kWalls,  ///< along the walls of every room at a clearance, then across its middle
  kSparse  ///< a patrol of a few way points a room
};

/// The kind of a route by its name, "walls" or "sparse"; nothing for any other text.
std::optional<RouteKind> parseRouteKind(std::string_view name);

/// The robot that drives a planned route, and its start.
struct RoutePlannerConfig {
  double robot_radius_m = 0.2;  ///< [m]
  double clearance_m = 0.3;     ///< between robot and walls, where the room is wide enough [m]
  std::optional<Position> start_in_map;  ///< [m], map frame; by default the middle of the widest
                                         ///< place of the largest region that the robot can reach
};

/// Every problem of a configuration, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const RoutePlannerConfig& config);

/// Plans a drive through the whole space that a round robot can reach from its start.
///
/// `kWalls` follows the walls of each room and of larger obstacles in it at the clearance. It
/// crosses rooms lengthwise, in lines at most 1.8 m apart. Then it visits places that are still
/// farther than 0.9 m of driving from these lines. `kSparse` has a way point in the middle of each
/// room. It adds more until no place is farther than about 3 m from one. Doors that the robot with
/// its clearance does not fit through divide rooms. The robot finishes one room before the next,
/// and the nearest room comes next. The planner is greedy: the drive is not the shortest one.
///
/// @return way points [m] from the start on, at least two, centres of cells; they pass requireFree
/// with the robot's radius.
/// @throw InputError naming every setting out of range, a start that is not free for the robot, or
/// a robot that fits nowhere or cannot move.
/// Deterministic. O(cells log cells) for each stroke of the drive, and mostly far less: searches
/// end at the nearest stroke.
std::vector<Position> planRoute(const Grid<CellState>& plan, RouteKind kind,
                                const RoutePlannerConfig& config = {});

}  // namespace sfw
