#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/constants.h"
#include "base/random.h"
#include "localization/place_estimate.h"
#include "localization/radio_map.h"
#include "localization/scan.h"

namespace sfw {

/// Follows a robot over a radio map by its scans (Monte Carlo localisation, Thrun et al. 2001).
///
/// A particle is a position with a velocity and the yaw of the odometry's frame in the map. With
/// odometry, its steps move the particles. Without, a particle keeps its velocity for a random time
/// and then takes one met on the mapped path, in either direction. So particles run along corridors
/// and do not lag behind a steady robot, as they would with a velocity that decays. A part of the
/// particles is drawn again from each scan alone, so that a robot that was carried away is found
/// again (sensor resetting, Lenser and Veloso 2000). Deterministic for a seed; not thread-safe.
class ParticleFilter {
 public:
  struct Config {
    std::size_t particles = 2000;
    std::int64_t seed = 0;
    double velocity_jitter = 0.15;     ///< standard deviation in a second, in the speed on the path
    double velocity_spread = 0.25;     ///< of a new velocity about one met on the path, likewise
    double odometry_error = 0.1;       ///< standard deviation of a step, in its length
    double odometry_yaw_error = 0.03;  ///< standard deviation of the frame's yaw [rad], each metre
    double redrawn = 0.02;             ///< part that each resampling draws again
    double start_yaw = kPi;            ///< largest yaw of a drawn particle's odometry frame [rad]
    double shared_way_m = 0.4;         ///< scans nearer than this share their errors
    double lost_after_s = 30.0;        ///< without scans for so long, the filter starts again
  };

  /// @param map must outlive this
  ParticleFilter(const RadioMap& map, const Config& config);

  /// Takes a scan and estimates where it was taken.
  /// @param step  of the odometry since the scan before, in its own frame [m], if there is one
  /// @return nothing before the first scan that holds a radio of the map.
  /// O(particles + places x radios heard).
  std::optional<PlaceEstimate> add(const Scan& scan,
                                   const std::optional<Position>& step = std::nullopt);

 private:
  void start(const std::vector<double>& probabilities);
  void draw(std::size_t particle, const std::vector<double>& sums);
  Position drawnVelocity();
  void move(double time_s, const std::optional<Position>& step);
  void weigh(const std::vector<double>& log_likelihood, double exponent);
  void resample(const std::vector<double>& probabilities);

  const RadioMap& map_;
  Config config_;
  Random random_;
  bool started_ = false;
  std::int64_t last_ns_ = 0;
  std::optional<Scan> before_;
  std::vector<Position> positions_;
  std::vector<Position> velocities_;
  std::vector<double> yaws_rad_;
  std::vector<double> weights_;
};

}  // namespace sfw
