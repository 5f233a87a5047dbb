#pragma once

#include <vector>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A drive along way points at constant speed, with turns on the spot between straight stretches.
///
/// The robot starts at the first way point and faces the second. Immutable.
class Route {
 public:
  /// @param speed_m_s,yaw_rate_rad_s  finite and positive
  /// @throw InputError if there are not two different way points, std::invalid_argument naming
  /// any other parameter.
  Route(const std::vector<Position>& way_points, double speed_m_s, double yaw_rate_rad_s);

  /// The time from the first way point to the last [s].
  double duration() const;

  /// The pose at a time. A time outside [0, duration()] gives the nearer end. O(log way points).
  RobotPose poseAt(double time_s) const;

  /// The distance driven until a time [m]. Limits and cost as of poseAt.
  double drivenAt(double time_s) const;

 private:
  /// A turn on the spot, then a straight stretch.
  struct Leg {
    double start_s;
    double drive_s;  // the turn is done
    double end_s;
    double driven_m;  // before it
    Position from;
    Position to;
    double yaw_rad;   // of the stretch
    double turn_rad;  // that led to it, in [-pi, pi]
  };

  /// The leg at a time within [0, duration()].
  const Leg& legAt(double time_s) const;

  std::vector<Leg> legs_;
};

/// Checks that a robot can drive a route without touching an obstacle.
///
/// Every cell must be free whose centre lies within `radius_m` plus half a cell's diagonal of the
/// route: these are the cells that the robot could touch.
/// @throw InputError naming every way point that is not free, every stretch between free way points
/// that is not free, and a cell in the way.
void requireFree(const Grid<CellState>& plan, const std::vector<Position>& way_points,
                 double radius_m);

}  // namespace sfw
