#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/export.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/types.h"
#include "structure_from_wifi/wall_segment.h"

namespace sfw {

/// A touch of an obstacle.
struct Touch {
  Position robot = Position::Zero();  ///< centre of the robot [m], map frame
  Position point = Position::Zero();  ///< point touched [m], map frame
};

/// The touches behind contacts: the robot was at the pose of its path nearest in time. Contacts at
/// that pose itself, and all without a path, are left out. O(contacts x poses).
SFW_EXPORT std::vector<Touch> touchesOf(const std::vector<Contact>& contacts,
                                        const std::vector<PathPose>& path);

/// What an exploring robot knows: a map, and what it met itself, the map's own time included.
struct ExplorationView {
  Grid<CellState> states;          ///< of the map
  Grid<float> occupied;            ///< probabilities, NaN where nothing is known; grid of `states`
  std::vector<WallSegment> walls;  ///< beside the way
  std::vector<Position> access_points = {};  ///< with a known or estimated position [m]
  std::vector<Position> way = {};            ///< of the robot, in order [m]
  std::vector<Touch> touches = {};           ///< in order
};

/// The view of a map: its cells, walls and access points, its path and its contacts.
SFW_EXPORT ExplorationView viewOf(const Snapshot& snapshot);

/// The robot that explores, and what counts as worth a drive.
struct ExplorationConfig {
  double robot_radius_m = 0.15;  ///< 0.05..1 [m]
  double speed_m_s = 0.5;        ///< of straight drives, 0.01..10 [m/s]
  double yaw_rate_rad_s = 1.5;   ///< of turns on the spot, 0.01..100 [rad/s]
  double touch_s = 8.0;          ///< time lost by a touch, 0..1000 [s]
  double view_m = 0.9;           ///< the map knows free space this far from the way, 0.1..5 [m]
  double least_gain_m2 = 0.3;    ///< goals of less gain are not worth a drive, 0..1000 [m2]
};

/// Every problem of the settings, one sentence each that starts with the setting's name.
SFW_EXPORT std::vector<std::string> validate(const ExplorationConfig& config);

/// A place worth a drive.
struct ExplorationGoal {
  Position position = Position::Zero();  ///< [m], map frame
  std::vector<Position> way;  ///< from the robot to the goal, straight between points [m]
  double travel_s = 0.0;      ///< expected time, with touches [s]
  double arrival = 0.0;       ///< probability to get there without a touch
  double area_m2 = 0.0;       ///< free space that the drive is expected to find [m2]
  double walls_m2 = 0.0;      ///< worth of new rays through undecided walls, as an area [m2]
  double rate_m2_s = 0.0;     ///< (area + walls) over time; goals are ranked by it [m2/s]

  /// Why the goal is worth its drive, in a sentence.
  std::string reason() const;
};

/// Ranks the next drives of a robot by what they teach a second.
///
/// A drive finds the free space near its way that the map does not know, as far as nothing hides
/// it. It also sends new rays through walls that the map is not sure of. Both are weighed with the
/// probability that the robot gets there: what it may touch comes from the map, from walls with
/// their confidence, and from the straight continuation of what it touched before.
/// O(cells log cells), over cells of 0.1 m.
/// @param robot     [m], map frame; the goals are reached from here
/// @param most      number of goals; they lie at least 1 m apart
/// @return the best first; empty if nothing is worth a drive
/// @throw InputError naming each setting that is out of range
SFW_EXPORT std::vector<ExplorationGoal> rankGoals(const ExplorationView& view,
                                                  const RobotPose& robot,
                                                  const ExplorationConfig& config,
                                                  std::size_t most = 1);

/// The quickest drive to a place, with the touches to expect; nothing if none is known.
/// @throw as rankGoals
SFW_EXPORT std::optional<ExplorationGoal> wayTo(const ExplorationView& view, const RobotPose& robot,
                                                const Position& target,
                                                const ExplorationConfig& config);

}  // namespace sfw
