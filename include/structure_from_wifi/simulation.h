#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Where a robot stands and looks, map frame.
struct RobotPose {
  Position position = Position::Zero();  ///< [m]
  double yaw_rad = 0.0;                  ///< counter-clockwise from x
};

/// Way points driven at constant speed, with a turn on the spot before each stretch that needs
/// one. The robot starts at the first way point, looking at the second. Immutable.
class Route {
 public:
  /// @param speed_m_s,yaw_rate_rad_s  finite and positive
  /// @throw InputError if there are not two different way points, std::invalid_argument naming
  /// any other parameter.
  Route(const std::vector<Position>& way_points, double speed_m_s, double yaw_rate_rad_s);

  /// From the first way point to the last [s].
  double duration() const;

  /// Time outside [0, duration()] gives the nearer end of the route. O(log way points).
  RobotPose poseAt(double time_s) const;

 private:
  /// A turn on the spot, then a straight stretch.
  struct Leg {
    double start_s;
    double drive_s;  // the turn is done
    double end_s;
    Position from;
    Position to;
    double yaw_rad;   // of the stretch
    double turn_rad;  // that led to it, in [-pi, pi]
  };

  std::vector<Leg> legs_;
};

/// Checks that a robot can drive a route: every cell whose centre comes within `radius_m` plus half
/// a cell's diagonal of it, thus every cell that the robot could touch, must be free.
/// @throw InputError naming every way point and, between good ones, every stretch that is not free,
/// and a cell that is in the way.
void requireFree(const Grid<CellState>& plan, const std::vector<Position>& way_points,
                 double radius_m);

/// Walls on the straight line between two points, each counted once however thick it is.
///
/// A wall is a run of occupied cells; cells that touch, even at a corner, belong to one wall and
/// leave no gap between them. Unknown cells and all outside the plan are no wall. Symmetric in its
/// ends, which must lie within the range of Ray. O(cells crossed).
int countWalls(const Grid<CellState>& plan, const Position& from, const Position& to);

/// Signal strength in a floor plan: log-distance path loss, loss per wall, shadowing that changes
/// slowly with place, and noise of each sample.
///
/// Every value is a function of its arguments and the seed, whatever was asked before, and the same
/// on all machines up to the last bit of their mathematical library. Immutable.
class RadioModel {
 public:
  /// Path loss and walls as fitted to a recording in a furnished flat at 2.4 GHz; noise somewhat
  /// kinder than measured in homes, whose ranges stand in brackets.
  struct Config {
    double rssi_at_1m = -31.0;        ///< (-28 to -34) [dBm]
    double exponent = 1.2;            ///< of path loss without the walls (1.0 to 2.4)
    double wall_loss = 8.3;           ///< of each wall (1.4 to 8.3) [dB]
    double shadowing = 2.5;           ///< standard deviation over places (3 to 8) [dB]
    double shadowing_distance = 1.5;  ///< its correlation falls to 1/e here (0.9 to 2.1) [m]
    double sample_noise = 2.0;        ///< standard deviation at one place (2.8 to 3.3) [dB]
    double antenna_height = 0.3;      ///< of the robot, for access points of known height [m]
    double sensitivity = -90.0;       ///< anything weaker is not heard [dBm]
    std::int64_t seed = 1;            ///< of shadowing and noise
  };

  /// @throw InputError naming every setting of `config` that is out of range and every access point
  /// outside the plan.
  RadioModel(const Grid<CellState>& plan, const std::vector<AccessPoint>& access_points,
             const Config& config);

  const std::vector<AccessPoint>& accessPoints() const { return access_points_; }

  /// What the mean of many samples tends to [dBm]; shadowing belongs to the place and is included.
  /// @param access_point    index in accessPoints()
  /// @param antenna_in_map  [m], inside the plan
  /// O(cells between them).
  double meanRssi(std::size_t access_point, const Position& antenna_in_map) const;

  /// One sample, in steps of 1 dB; nothing if it is too weak to be heard.
  /// @param sample  tells samples of one access point apart
  std::optional<double> rssi(std::size_t access_point, const Position& antenna_in_map,
                             std::uint64_t sample) const;

 private:
  /// One of the many plane waves whose sum is the shadowing.
  struct Wave {
    Position rad_per_m;
    double phase_rad;
  };

  std::vector<Wave> makeWaves(std::size_t access_point) const;
  double shadowing(std::size_t access_point, const Position& antenna_in_map) const;

  Grid<CellState> plan_;
  std::vector<AccessPoint> access_points_;
  Config config_;
  std::vector<std::vector<Wave>> waves_;  // of each access point
};

/// Every problem of a radio's settings, one sentence each that starts with the setting's name.
std::vector<std::string> validate(const RadioModel::Config& config);

}  // namespace sfw
