#pragma once

namespace sfw {

/// A command to a robot, in its own frame.
struct DriveCommand {
  double speed_m_s = 0.0;       ///< forwards; backwards if negative
  double yaw_rate_rad_s = 0.0;  ///< counter-clockwise
};

}  // namespace sfw
