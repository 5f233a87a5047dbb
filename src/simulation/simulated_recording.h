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

/// When a simulated radio hears what.
enum class Listening : std::uint8_t {
  kLink,  ///< every access point at each sample, as from one associated radio for each
  kScans  ///< all channels in turn: each access point once a scan, at a time of its own
};

/// How a recording is made. All that is random follows from `radio.seed`.
struct RecordingConfig {
  double speed_m_s = 0.5;       ///< [m/s]
  double yaw_rate_rad_s = 2.0;  ///< of turns on the spot [rad/s]
  Listening listening = Listening::kLink;
  double link_rate_hz = 5.0;   ///< samples a second, measured 5 to 20 [Hz]
  double scan_period_s = 2.0;  ///< of a full scan, measured 1 to 4 [s]
  double start_s = 1000.0;     ///< stamp at the start of the drive [s]; 0 is no time to ROS

  /// Error of the reported positions: standard deviation on each axis, a smooth function of the
  /// true position, as from maps that register slightly wrong, so a place has the same one on
  /// every visit (.03 to .18) [m].
  double registration_error_m = 0.0;
  double registration_distance_m = 3.0;  ///< its correlation falls to 1/e here [m]

  /// Error that grows with the way driven, as of odometry alone: its root mean square as a share
  /// of that way. It changes its direction slowly, over some ten metres.
  double drift = 0.0;

  RadioModel::Config radio;
};

/// Every problem of a recording's settings, one sentence each that starts with the setting's name;
/// the radio's names follow `radio/`.
std::vector<std::string> validate(const RecordingConfig& config);

/// What a robot believes wrongly about its position, for each of the two reasons. Immutable.
class PositionError {
 public:
  /// Takes the errors and the seed from a valid configuration.
  explicit PositionError(const RecordingConfig& config);

  /// That of the map's registration at a true position [m], map frame.
  Position registration(const Position& position) const;

  /// That of odometry after a way [m], map frame.
  Position drift(double driven_m) const;

 private:
  double registration_error_;
  double drift_;
  RandomField registration_x_;
  RandomField registration_y_;
  RandomField drift_x_;  // of the way driven, on the x axis
  RandomField drift_y_;
};

/// Where the robot is and where it believes to be. Immutable.
class SimulatedDrive {
 public:
  /// @throw InputError naming each setting that is out of range, or if there are no two different
  /// way points.
  SimulatedDrive(const std::vector<Position>& way_points, const RecordingConfig& config);

  double duration() const { return route_.duration(); }  ///< [s]

  /// @param time_s  since the start; outside [0, duration()] the nearer end
  RobotPose truePose(double time_s) const { return route_.poseAt(time_s); }

  /// The true pose with the position's errors; the heading is exact.
  RobotPose reportedPose(double time_s) const;

 private:
  Route route_;
  PositionError error_;
};

/// The truth about one reading.
struct ReadingTruth {
  RobotPose pose;                ///< where it was really made, map frame
  std::size_t access_point = 0;  ///< index among the transmitters
  int walls = 0;                 ///< between the two, as countWalls has it
};

/// What a simulated robot brings home.
struct SimulatedRecording {
  std::vector<Reading> readings;    ///< at reported positions; by stamp, then by access point
  std::vector<ReadingTruth> truth;  ///< of each reading
};

/// Drives a robot through a building and records what it hears. The whole way is listened to; the
/// way is not checked for obstacles (requireFree does).
/// @throw InputError naming each setting that is out of range and each access point outside the
/// plan, or if there are no two different way points.
/// O(samples x (cells crossed + pieces of furniture)).
SimulatedRecording simulateRecording(const FloorPlan& plan, const std::vector<Position>& way_points,
                                     const std::vector<Transmitter>& transmitters,
                                     const RecordingConfig& config);

}  // namespace sfw
