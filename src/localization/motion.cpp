#include "localization/motion.h"

#include <algorithm>
#include <cmath>

namespace sfw {

Motion motionOf(const std::vector<Scan>& scans) {
  constexpr double kShortestS = 2.0;
  constexpr double kLongestS = 20.0;
  constexpr double kLeastSpeed = 0.05;
  constexpr double kLeastCorrelation = 0.05;
  double squares = 0.0;
  double steps = 0.0;
  double time_s = 0.0;
  double products = 0.0;
  double squares_before = 0.0;
  Motion motion;
  Position before = Position::Zero();  // the velocity of the step before
  bool has_before = false;
  std::size_t from = 0;
  for (std::size_t i = 1; i < scans.size(); ++i) {
    const double step_s = 1e-9 * static_cast<double>(scans[i].stamp_ns - scans[from].stamp_ns);
    if (step_s < 0.0) {  // the next robot
      from = i;
      has_before = false;
      continue;
    }
    if (step_s < kShortestS) {
      continue;
    }
    const Position velocity = (scans[i].position - scans[from].position) / step_s;
    const bool is_step = step_s <= kLongestS;
    if (is_step) {
      motion.velocities.push_back(velocity);
      squares += velocity.squaredNorm();
      time_s += step_s;
      steps += 1.0;
    }
    if (is_step && has_before) {
      products += velocity.dot(before);
      squares_before += before.squaredNorm();
    }
    before = velocity;
    has_before = is_step;
    from = i;
  }
  if (steps > 0.0) {
    motion.speed = std::max(std::sqrt(squares / steps), kLeastSpeed);
  }
  if (squares_before > 0.0) {
    const double correlation =
        std::clamp(products / squares_before, kLeastCorrelation, 1.0 - kLeastCorrelation);
    motion.velocity_time_s = -time_s / steps / std::log(correlation);
  }
  return motion;
}

}  // namespace sfw
