#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "structure_from_wifi/bssid.h"
#include "structure_from_wifi/robot_name.h"

namespace sfw {

/// A point in the map frame [m]. Unlike Eigen::Vector2d, it needs no alignment to 16 bytes, so the
/// structs below have no gaps. It converts from and to vectors of Eigen.
using Position = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

/// The position and heading of a robot in the map frame.
struct RobotPose {
  Position position = Position::Zero();  ///< [m]
  double yaw_rad = 0.0;                  ///< counter-clockwise from x
};

/// The signal strength of one access point, measured at one position.
struct Reading {
  std::int64_t stamp_ns = 0;                   ///< since the epoch of the clock in use
  Position antenna_in_map = Position::Zero();  ///< [m]
  Bssid bssid;                                 ///< of the access point
  double rssi_dbm = 0.0;                       ///< received power
  RobotName robot = {};                        ///< name of the robot; empty: the only one
};

/// A reading in a list that already gives its access point and time.
struct Sample {
  Position antenna_in_map = Position::Zero();  ///< [m]
  double rssi_dbm = 0.0;                       ///< received power
};

/// A point at which the robot touched an obstacle.
struct Contact {
  std::int64_t stamp_ns = 0;                 ///< of the touch
  Position point_in_map = Position::Zero();  ///< [m]
  RobotName robot = {};                      ///< name of the robot; empty: the only one
};

/// A pose of the path.
struct PathPose {
  std::int64_t stamp_ns = 0;                   ///< of the pose
  Position antenna_in_map = Position::Zero();  ///< [m]
  int walls = kNoWallCount;  ///< fewest walls to any access point with a reading at this pose
  RobotName robot = {};      ///< name of the robot; empty: the only one

  /// The value of `walls` where no reading gave a count.
  static constexpr int kNoWallCount = -1;
};

/// A radio transmitter at a fixed position.
struct AccessPoint {
  Bssid bssid;                           ///< of its radio
  std::string name;                      ///< shown to people; may be empty
  Position position = Position::Zero();  ///< [m], map frame
  std::optional<double> height_m;        ///< above the floor
  std::optional<double> tx_dbm;          ///< transmitted power
  bool position_known = true;            ///< false: the position is to be estimated

  /// Standard deviation of the given position on each axis [m], above 0. With it, the position is
  /// the mean of a Gaussian prior, and is estimated from the readings too. Empty: it is exact.
  std::optional<double> position_sd_m = {};
};

/// Axis-aligned rectangle in the map frame [m].
using Box = Eigen::AlignedBox2d;

}  // namespace sfw
