#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>

#include "structure_from_wifi/bssid.h"

namespace sfw {

/// A point in the map frame [m].
using Position = Eigen::Vector2d;

/// One signal strength heard at one place.
struct Reading {
  std::int64_t stamp_ns = 0;
  Position antenna_in_map = Position::Zero();  ///< [m]
  Bssid bssid;
  double rssi_dbm = 0.0;
};

/// A place where the robot touched an obstacle.
struct Contact {
  std::int64_t stamp_ns = 0;
  Position point_in_map = Position::Zero();  ///< [m]
};

/// A transmitter.
struct AccessPoint {
  Bssid bssid;
  std::string name;                      ///< for people; may be empty
  Position position = Position::Zero();  ///< [m], map frame
  std::optional<double> height_m;        ///< above the floor
  std::optional<double> tx_dbm;          ///< transmitted power
  bool position_known = true;            ///< false: the position is to be estimated
};

/// Axis-aligned rectangle in the map frame [m].
using Box = Eigen::AlignedBox2d;

}  // namespace sfw
