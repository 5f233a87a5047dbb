#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulation/building/floor_plan.h"
#include "simulation/radio/radio_model.h"
#include "simulation/radio/random_field.h"
#include "simulation/robot/route.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// The times at which a simulated radio receives access points.
enum class Listening : std::uint8_t {
  kLink,  ///< every access point at each sample, as with one associated radio for each of them
  kScans  ///< each access point once in a scan, at its own time, as with a radio that changes
          ///< channels
};

/// The settings of a recording. All random numbers follow from `radio.seed`.
struct RecordingConfig {
  double speed_m_s = 0.5;       ///< [m/s]
  double yaw_rate_rad_s = 2.0;  ///< of turns on the spot [rad/s]
  Listening listening = Listening::kLink;
  double link_rate_hz = 5.0;   ///< samples a second, measured 5 to 20 [Hz]
  double scan_period_s = 2.0;  ///< of a full scan, measured 1 to 4 [s]
  double start_s = 1000.0;     ///< stamp at the start of the drive [s]; 0 is no time to ROS

  /// Standard deviation of the error of reported positions, on each axis (.03 to .18) [m]. The
  /// error is a smooth function of the true position, as with a slightly wrong map registration. So
  /// a place has the same error on every visit.
  double registration_error_m = 0.0;
  double registration_distance_m = 3.0;  ///< at which its correlation is 1/e [m]

  /// Root mean square of the odometry's error, as a share of the distance driven. Its direction
  /// changes slowly, over some ten metres.
  double drift = 0.0;

  RadioModel::Config radio;
};

/// Every problem of a recording's settings, one sentence each that starts with the setting's name.
/// Names of the radio's settings follow `radio/`.
std::vector<std::string> validate(const RecordingConfig& config);

/// The errors of a robot's reported position: registration and drift. Immutable.
class PositionError {
 public:
  /// Takes the errors and the seed from a valid configuration.
  explicit PositionError(const RecordingConfig& config);

  /// The error of the map's registration at a true position [m], map frame.
  Position registration(const Position& position) const;

  /// The error of odometry after a distance driven [m], map frame.
  Position drift(double driven_m) const;

 private:
  double registration_error_;
  double drift_;
  RandomField registration_x_;
  RandomField registration_y_;
  RandomField drift_x_;  // a function of the distance driven, on the x axis
  RandomField drift_y_;
};

/// The true and the reported poses of a robot on a route. Immutable.
class SimulatedDrive {
 public:
  /// @throw InputError naming each setting that is out of range, or if there are no two different
  /// way points.
  SimulatedDrive(const std::vector<Position>& way_points, const RecordingConfig& config);

  double duration() const { return route_.duration(); }  ///< [s]

  /// The pose at a time since the start. A time outside [0, duration()] gives the nearer end.
  RobotPose truePose(double time_s) const { return route_.poseAt(time_s); }

  /// The true pose with the errors of position. The heading is exact.
  RobotPose reportedPose(double time_s) const;

 private:
  Route route_;
  PositionError error_;
};

/// The truth about one reading.
struct ReadingTruth {
  RobotPose pose;                ///< true pose of the robot, map frame
  std::size_t access_point = 0;  ///< index among the transmitters
  int walls = 0;                 ///< between the two, as countWalls finds them
};

/// The readings of a simulated drive and their truth.
struct SimulatedRecording {
  std::vector<Reading> readings;    ///< at reported positions; by stamp, then by access point
  std::vector<ReadingTruth> truth;  ///< of each reading
};

/// Drives a robot through a building and records the signals that it receives on the whole route.
/// The route is not checked for obstacles; requireFree does that.
/// @throw InputError naming each setting that is out of range and each access point outside the
/// plan, or if there are no two different way points.
/// O(samples x (cells crossed + pieces of furniture)).
SimulatedRecording simulateRecording(const FloorPlan& plan, const std::vector<Position>& way_points,
                                     const std::vector<Transmitter>& transmitters,
                                     const RecordingConfig& config);

}  // namespace sfw
