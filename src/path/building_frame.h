#pragma once

#include <vector>

#include "structure_from_wifi/types.h"

namespace sfw {

/// The direction that a building's walls lie in, as far as a robot's way shows it.
struct BuildingFrame {
  /// What the direction was read from.
  enum class Source {
    kHeadings,  ///< the robot drives mostly along two directions at right angles
    kSpread,    ///< the long side of the area driven
    kNone       ///< neither shows: the map's own axes
  };

  double yaw_rad = 0.0;  ///< of the building's x axis in the map frame, in [-pi/4, pi/4)
  Source source = Source::kNone;

  /// The map's coordinates seen from the building's axes: a rotation about the map's origin.
  Position toBuilding(const Position& in_map) const {
    return Eigen::Rotation2Dd(-yaw_rad) * in_map;
  }
  Position toMap(const Position& in_building) const {
    return Eigen::Rotation2Dd(yaw_rad) * in_building;
  }
};

/// Reads the building's direction from a path, up to quarter turns.
///
/// Headings of pieces of 0.4 m vote with the angle of exp(4 i heading), refined by the mean of
/// those within 8 degrees of it; where the votes scatter, the longer principal axis of the
/// positions decides.
/// @param path  positions [m] in the order driven; pieces longer than `max_gap` are no heading
BuildingFrame findBuildingFrame(const std::vector<Position>& path, double max_gap);

}  // namespace sfw
