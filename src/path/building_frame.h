#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// Direction of a building's walls, estimated from the path of the robot.
struct BuildingFrame {
  /// Evidence for the direction.
  enum class Source {
    kHeadings,  ///< the robot drives mostly along two directions at right angles
    kSpread,    ///< the long side of the area driven
    kNone       ///< none: the map's own axes
  };

  double yaw_rad = 0.0;  ///< of the building's x axis in the map frame, in [-pi/4, pi/4)
  Source source = Source::kNone;

  /// Turns map coordinates into building coordinates: a rotation about the map's origin. Take
  /// toBuildingAxes() for many points.
  Position toBuilding(const Position& in_map) const { return toBuildingAxes() * in_map; }

  /// The rotation of toBuilding.
  Eigen::Matrix2d toBuildingAxes() const { return Eigen::Rotation2Dd(-yaw_rad).toRotationMatrix(); }
  Eigen::Matrix2d toBuilding(const Eigen::Matrix2d& covariance_in_map) const {
    const Eigen::Matrix2d turn = toBuildingAxes();
    return turn * covariance_in_map * turn.transpose();
  }
  Position toMap(const Position& in_building) const {
    return Eigen::Rotation2Dd(yaw_rad) * in_building;
  }
};

/// Estimates the building's direction from a path, up to quarter turns.
///
/// Each piece of 0.4 m votes with the angle of exp(4 i heading). The mean of the headings within 8
/// degrees of the result refines it. If the votes scatter, the longer principal axis of the
/// positions decides.
/// @param path       positions [m] in the order driven
/// @param max_gap_m  longer steps have no heading
BuildingFrame findBuildingFrame(const std::vector<Position>& path, double max_gap_m);

}  // namespace sfw
