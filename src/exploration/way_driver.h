#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/drive_command.h"
#include "exploration/driver.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Drives a robot that has nothing but bumpers.
///
/// It drives to the points of its way in curves, and turns on the spot where these would be too
/// wide. After a touch it backs off, and the way is blocked. A robot that does not come forward
/// frees itself: it backs off, turns, and drives in another direction. Not thread-safe.
class WayDriver : public Driver {
 public:
  struct Config {
    double speed_m_s = 0.5;         ///< forwards [m/s]
    double yaw_rate_rad_s = 1.5;    ///< of turns on the spot [rad/s]
    double back_off_m = 0.12;       ///< after a touch [m]
    double arrival_m = 0.1;         ///< a point of the way is reached this near [m]
    double patience_s = 3.0;        ///< without motion before the robot frees itself [s]
    std::size_t most_escapes = 12;  ///< without success before it is stuck
  };

  explicit WayDriver(const Config& config) : config_(config) {}

  void follow(std::vector<Position> way) override;
  void stop() override;
  State step(const RobotPose& pose, bool touching, double now_s) override;

  /// What the robot shall do after the last step.
  const DriveCommand& command() const { return command_; }

  /// The points of the way that are still ahead.
  std::vector<Position> rest() const {
    return {way_.begin() + static_cast<std::ptrdiff_t>(next_), way_.end()};
  }

 private:
  enum class Reflex { kNone, kBackOff, kTurn, kLeave };

  void drive(const RobotPose& pose);
  void reflex(const RobotPose& pose, bool touching, double now_s);
  void begin(Reflex reflex, const RobotPose& pose, double now_s);
  double turnRate(double error_rad) const;
  bool comesForward(const RobotPose& pose, double now_s);

  Config config_;
  DriveCommand command_;
  State state_ = State::kIdle;
  std::vector<Position> way_;
  std::size_t next_ = 0;  // point of the way
  bool turning_ = true;

  Reflex reflex_ = Reflex::kNone;
  RobotPose reflex_from_;
  double reflex_start_s_ = 0.0;
  bool escaping_ = false;
  double escape_yaw_rad_ = 0.0;

  std::size_t escapes_ = 0;
  std::optional<RobotPose> last_moved_;
  double last_moved_s_ = 0.0;
};

}  // namespace sfw
