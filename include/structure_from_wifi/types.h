#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sfw {

/// A point in the map frame [m].
using Position = Eigen::Vector2d;

/// Hardware address of an access point's radio: the key that readings and access points share.
class Bssid {
 public:
  /// Reads six pairs of hexadecimal digits joined by ':' or '-', in either case.
  /// @return nothing if the text is malformed or all zero (a radio that is not associated).
  static std::optional<Bssid> parse(std::string_view text);

  /// The canonical form, lower case with colons.
  std::string str() const;

  friend bool operator==(Bssid a, Bssid b) { return a.value_ == b.value_; }
  friend bool operator!=(Bssid a, Bssid b) { return a.value_ != b.value_; }
  friend bool operator<(Bssid a, Bssid b) { return a.value_ < b.value_; }

 private:
  std::uint64_t value_ = 0;
};

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
