#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "ros/mapping/localization.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Watches the poses of readings of each robot for what a robot on a floor cannot do: tilt and
/// jump.
class PoseWatch {
 public:
  /// @param max_tilt_rad   larger tilts are counted
  /// @param max_speed_m_s  readings at poses that the robot cannot reach at this speed are not
  ///                       usable; 0: all are
  PoseWatch(double max_tilt_rad, double max_speed_m_s)
      : max_tilt_rad_(max_tilt_rad), max_speed_m_s_(max_speed_m_s) {}

  /// Looks at the next observation. One without readings, as of contacts, is usable.
  bool isUsable(const LocatedObservation& observation);

  std::size_t tilted() const { return tilted_; }  ///< observations, since the start
  double largestTilt() const { return largest_tilt_rad_; }
  std::size_t jumped() const { return jumped_; }  ///< unusable observations, since the start

  /// Forgets the poses, not the counts: what comes next may be anywhere.
  void clear();

 private:
  /// What is remembered of one robot.
  struct Watched {
    std::optional<Eigen::Vector3d> first_up;  // an antenna may be mounted in any direction
    std::optional<Reading> last;              // that was usable
  };

  void measureTilt(const Eigen::Vector3d& up_in_sensor, Watched& robot);
  bool isWithinReach(const Reading& reading, const Watched& robot) const;

  const double max_tilt_rad_, max_speed_m_s_;
  std::map<std::string, Watched> robots_;  // by name
  std::size_t tilted_ = 0, jumped_ = 0;
  double largest_tilt_rad_ = 0.0;
};

}  // namespace sfw
