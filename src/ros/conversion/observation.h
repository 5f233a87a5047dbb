#pragma once

#include <ros/time.h>

#include <Eigen/Core>
#include <cstddef>
#include <map>
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
  std::string robot = {};  ///< antenna frame of the robot that made a scan, if there are several
};

/// Whether the mapper can use an observation. It counts the others, and tells why.
inline bool isUsable(const Observation& observation) {
  const auto* reading = std::get_if<UnlocatedReading>(&observation.content);
  return reading == nullptr || isInRssiRange(reading->rssi_dbm);
}

/// The usable observations of a message, and why others were left out.
struct Conversion {
  std::vector<Observation> observations = {};
  std::string problem = {};  ///< of the message, the first one, in words; empty if there is none
  std::map<std::string, std::size_t> rejected = {};  ///< readings, clouds or messages, by reason
  std::string frame = {};  ///< of a scan, without a leading slash; empty if it has none

  /// Counts something left out. The first reason is the problem, too.
  void reject(const std::string& reason, std::size_t count = 1) {
    rejected[reason] += count;
    if (problem.empty()) {
      problem = reason;
    }
  }
};

/// The conversion of a message, or of a cloud, that is left out.
inline Conversion rejection(const std::string& reason) {
  Conversion conversion;
  conversion.reject(reason);
  return conversion;
}

}  // namespace sfw
