#include "path/odometry_checks.h"

#include <cstddef>

namespace sfw {
namespace {

Position antennaInOdom(const OdometryCorrection& correction) {
  return Eigen::Rotation2Dd(-correction.odom_yaw_rad) *
         (correction.antenna_in_map - correction.odom_in_map);
}

/// Whether most steps of the path are none in the frame of the odometry.
bool isFixedToRobot(const std::vector<OdometryCorrection>& corrections) {
  constexpr double kMoves = 0.01;      // [m]
  constexpr double kHardly = 0.1;      // of the step in the map
  constexpr std::size_t kFewest = 10;  // a robot at rest may jump a few times
  std::size_t steps = 0;
  std::size_t frozen = 0;
  for (std::size_t i = 1; i < corrections.size(); ++i) {
    const OdometryCorrection& from = corrections[i - 1];
    const OdometryCorrection& to = corrections[i];
    const double way = (to.antenna_in_map - from.antenna_in_map).norm();
    if (way > kMoves) {
      ++steps;
      frozen += (antennaInOdom(to) - antennaInOdom(from)).norm() < kHardly * way ? 1 : 0;
    }
  }
  return frozen >= kFewest && 2 * frozen > steps;
}

/// Whether many jumps lead back to where the jump before began.
bool goesToAndFro(const std::vector<OdometryCorrection>& corrections,
                  const PathCorrector::Tolerance& tolerance) {
  constexpr std::size_t kFewest = 5;
  constexpr std::size_t kShare = 4;  // tf may interpolate, so not each jump leads all the way back
  std::size_t jumps = 0;
  std::size_t returns = 0;
  const OdometryCorrection* before = nullptr;  // before the last jump
  for (std::size_t i = 1; i < corrections.size(); ++i) {
    if (!PathCorrector::isJump(corrections[i - 1], corrections[i], tolerance)) {
      continue;
    }
    ++jumps;
    if (before != nullptr && !PathCorrector::isJump(*before, corrections[i], tolerance)) {
      ++returns;
    }
    before = &corrections[i - 1];
  }
  return returns >= kFewest && kShare * returns >= jumps;
}

}  // namespace

bool areOfOdometry(const std::vector<OdometryCorrection>& corrections,
                   const PathCorrector::Tolerance& tolerance) {
  return !isFixedToRobot(corrections) && !goesToAndFro(corrections, tolerance);
}

}  // namespace sfw
