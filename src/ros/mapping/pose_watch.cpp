#include "ros/mapping/pose_watch.h"

#include <algorithm>
#include <cmath>

namespace sfw {

void PoseWatch::measureTilt(const Eigen::Vector3d& up_in_sensor) {
  if (!first_up_) {
    first_up_ = up_in_sensor;
  }
  const double tilt_rad =
      std::atan2(first_up_->cross(up_in_sensor).norm(), first_up_->dot(up_in_sensor));
  if (tilt_rad > max_tilt_rad_) {
    ++tilted_;
    largest_tilt_rad_ = std::max(largest_tilt_rad_, tilt_rad);
  }
}

bool PoseWatch::isWithinReach(const Reading& reading) const {
  constexpr double kCorrection = 1.0;  // [m] that a localisation may move a robot that is at rest
  constexpr double kNanoseconds = 1e9;
  if (max_speed_m_s_ <= 0.0 || !last_) {
    return true;
  }
  // In double: stamps may be farther apart than an int64 of nanoseconds reaches.
  const double seconds =
      std::abs(static_cast<double>(reading.stamp_ns) - static_cast<double>(last_->stamp_ns)) /
      kNanoseconds;
  return (reading.antenna_in_map - last_->antenna_in_map).norm() <=
         kCorrection + max_speed_m_s_ * seconds;
}

bool PoseWatch::isUsable(const LocatedObservation& observation) {
  if (observation.readings.empty()) {
    return true;
  }
  measureTilt(observation.up_in_sensor);
  if (!isWithinReach(observation.readings.front())) {
    ++jumped_;
    return false;
  }
  last_ = observation.readings.front();
  return true;
}

void PoseWatch::clear() {
  first_up_.reset();
  last_.reset();
}

}  // namespace sfw
