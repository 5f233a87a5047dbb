#pragma once

#include <ros/time.h>

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "base/rssi_range.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A signal strength at an unknown position.
struct UnlocatedReading {
  Bssid bssid;
  double rssi_dbm = 0.0;
};

/// Obstacles that the robot touched, in the frame of its sensor [m].
struct UnlocatedContacts {
  std::string frame;
  std::vector<Eigen::Vector3d> points;
};

/// A reading or contacts at a time, before tf gives their position.
struct Observation {
  ros::Time stamp;
  std::variant<UnlocatedReading, UnlocatedContacts> content;
  std::string robot = {};  ///< antenna frame of the robot, if a scan of several robots names it
};

/// Whether the mapper can use an observation. It counts the others, and tells why.
inline bool isUsable(const Observation& observation) {
  const auto* reading = std::get_if<UnlocatedReading>(&observation.content);
  return reading == nullptr || isInRssiRange(reading->rssi_dbm);
}

/// The usable observations of a message, with the count and the problem of the others.
struct Conversion {
  std::vector<Observation> observations = {};
  std::size_t rejected = 0;  ///< readings, clouds or whole messages left out
  std::string problem = {};  ///< of the message, in words; empty if there is none
  std::string frame = {};    ///< of a scan, without a leading slash; empty if it has none
};

}  // namespace sfw
