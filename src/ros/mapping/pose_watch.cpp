#include "ros/mapping/pose_watch.h"

#include <algorithm>
#include <cmath>

namespace sfw {

void PoseWatch::measureTilt(const Eigen::Vector3d& up_in_sensor, Watched& robot) {
  if (!robot.first_up) {
    robot.first_up = up_in_sensor;
  }
  const double tilt_rad =
      std::atan2(robot.first_up->cross(up_in_sensor).norm(), robot.first_up->dot(up_in_sensor));
  if (tilt_rad > max_tilt_rad_) {
    ++tilted_;
    largest_tilt_rad_ = std::max(largest_tilt_rad_, tilt_rad);
  }
}

bool PoseWatch::isWithinReach(const Reading& reading, const Watched& robot) const {
  constexpr double kCorrection = 1.0;  // [m] that a localisation may move a robot that is at rest
  constexpr double kNanoseconds = 1e9;
  if (max_speed_m_s_ <= 0.0 || !robot.last) {
    return true;
  }
  // In double: stamps may be farther apart than an int64 of nanoseconds reaches.
  const double seconds =
      std::abs(static_cast<double>(reading.stamp_ns) - static_cast<double>(robot.last->stamp_ns)) /
      kNanoseconds;
  return (reading.antenna_in_map - robot.last->antenna_in_map).norm() <=
         kCorrection + max_speed_m_s_ * seconds;
}

bool PoseWatch::isUsable(const LocatedObservation& observation) {
  if (observation.readings.empty()) {
    return true;
  }
  const Reading& reading = observation.readings.front();
  Watched& robot = robots_[reading.robot];
  measureTilt(observation.up_in_sensor, robot);
  if (!isWithinReach(reading, robot)) {
    ++jumped_;
    return false;
  }
  robot.last = reading;
  return true;
}

void PoseWatch::clear() { robots_.clear(); }

}  // namespace sfw
