#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/drive_command.h"
#include "simulation/robot/route.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A round robot on two driven wheels, among walls that stop it.
///
/// The robot drives arcs, in chords of at most 10 ms each. Each chord is checked exactly against
/// the squares of all cells that are not free, the surroundings of the plan included. So the robot
/// never drives into or through a wall at any speed. A wall stops the robot on the spot and sets
/// its speed to zero: the robot does not slide along walls. It is round, so it can still turn and
/// drive away. Not thread-safe.
class SimulatedRobot {
 public:
  struct Config {
    double radius_m = 0.15;                ///< 0.01..10 [m]
    double max_speed_m_s = 0.5;            ///< forwards and backwards, 0.01..10 [m/s]
    double max_yaw_rate_rad_s = 2.0;       ///< both ways, 0.01..100 [rad/s]
    double acceleration_m_s2 = 1.0;        ///< speeding up and braking, 0.01..1000 [m/s2]
    double yaw_acceleration_rad_s2 = 5.0;  ///< speeding up and braking, 0.01..10000 [rad/s2]
    double command_timeout_s =
        0.5;  ///< brakes when the last command is older, 0..3600 [s]; 0: never
  };

  /// @param start  map frame; the robot stands still there
  /// @throw InputError naming each setting that is out of range, or the obstacle if the robot does
  /// not fit there.
  SimulatedRobot(const Grid<CellState>& plan, const RobotPose& start, const Config& config);

  /// Sets the command until the next command or the time-out. Speeds are clamped to the robot's
  /// own.
  /// @return false, without a change, if a number is not finite.
  bool command(const DriveCommand& command);

  /// Continues the drive for a time [s], which must be finite and not negative.
  /// O(time / 10 ms x cells that the robot covers).
  void step(double duration_s);

  const RobotPose& pose() const { return pose_; }
  double drivenDistance() const { return driven_m_; }  ///< forwards and backwards [m]
  double speed() const { return speed_m_s_; }          ///< [m/s]

  /// The nearest point [m], map frame, of an obstacle within 0.1 mm that keeps the robot from
  /// driving forwards. A bumper on its front half would detect it. Nothing if there is none.
  std::optional<Position> contact() const;

 private:
  /// A straight drive that an obstacle may end.
  struct FreePath {
    double length_m;
    std::optional<Position> obstacle;  // the point touched at its end
  };

  void driveChord(double duration_s);
  FreePath freePath(const Position& direction, double length_m) const;

  /// Calls `visit(Box)` for the square of each obstacle within a distance of a rectangle.
  template <class Visitor>
  void forEachObstacle(const Box& around, double distance_m, Visitor&& visit) const;

  Grid<CellState> plan_;
  Config config_;
  RobotPose pose_;
  DriveCommand command_;
  double command_age_s_ = 0.0;
  double speed_m_s_ = 0.0;
  double yaw_rate_rad_s_ = 0.0;
  double driven_m_ = 0.0;
};

/// Every problem of a robot's settings, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const SimulatedRobot::Config& config);

}  // namespace sfw
