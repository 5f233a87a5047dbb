#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "localization/heard_hall.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A hall through which a robot drives twice, by odometry that turns by an error with each metre.
struct DriftedHall {
  double turn_error_rad = 0.0;  // for each metre
  double noise_db = 2.0;

  /// Up and down the hall on three lanes, twice. The robot drives from lane to lane, too.
  std::vector<Scan> truth() const {
    const HeardHall hall{1, noise_db, 3};
    std::vector<Position> corners;
    for (int round = 0; round < 2; ++round) {
      for (const Position& corner :
           {Position(1.0, 2.0), Position(19.0, 2.0), Position(19.0, 6.0), Position(1.0, 6.0),
            Position(1.0, 10.0), Position(19.0, 10.0)}) {
        corners.push_back(corner);
      }
    }
    std::vector<Scan> scans;
    double stamp_s = 1.0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Position way = corners[i] - corners[i - 1];
      constexpr double kStepM = 0.5;
      for (double at_m = 0.0; at_m < way.norm(); at_m += kStepM, stamp_s += 1.0) {
        scans.push_back(hall.scanAt(corners[i - 1] + at_m * way.normalized(), stamp_s));
      }
    }
    return scans;
  }

  /// Where the odometry takes each scan of the truth to be.
  std::vector<Position> odometry() const {
    const std::vector<Scan> scans = truth();
    std::vector<Position> path{scans.front().position};
    double turn_rad = 0.0;
    for (std::size_t i = 1; i < scans.size(); ++i) {
      const Position step = scans[i].position - scans[i - 1].position;
      turn_rad += turn_error_rad * step.norm();
      path.push_back(path.back() + Eigen::Rotation2Dd(turn_rad) * step);
    }
    return path;
  }

  /// The readings at these positions.
  std::vector<Reading> readings() const {
    const std::vector<Scan> scans = truth();
    const std::vector<Position> path = odometry();
    std::vector<Reading> readings;
    for (std::size_t i = 0; i < scans.size(); ++i) {
      for (const auto& [bssid, rssi_dbm] : scans[i].heard) {
        readings.push_back({scans[i].stamp_ns, path[i], bssid, rssi_dbm});
      }
    }
    return readings;
  }
};

}  // namespace sfw
