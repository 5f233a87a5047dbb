#include "localization/particle_filter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/random_streams.h"

namespace sfw {
namespace {

std::vector<double> sumsOf(const std::vector<double>& probabilities) {
  std::vector<double> sums(probabilities.size());
  std::partial_sum(probabilities.begin(), probabilities.end(), sums.begin());
  return sums;
}

std::size_t drawn(const std::vector<double>& sums, double share) {
  const auto found = std::lower_bound(sums.begin(), sums.end(), share * sums.back());
  return std::min(static_cast<std::size_t>(found - sums.begin()), sums.size() - 1);
}

}  // namespace

ParticleFilter::ParticleFilter(const RadioMap& map, const Config& config)
    : map_(map),
      config_(config),
      random_(config.seed, streamOf(Purpose::kLocalization), 0),
      positions_(config.particles),
      velocities_(config.particles),
      yaws_rad_(config.particles),
      weights_(config.particles) {}

std::optional<PlaceEstimate> ParticleFilter::add(const Scan& scan,
                                                 const std::optional<Position>& step) {
  const double time_s =
      started_ ? std::max(1e-9 * static_cast<double>(scan.stamp_ns - last_ns_), 0.0) : 0.0;
  const std::optional<std::vector<double>> likelihood =
      map_.logLikelihood(before_ ? withoutRepeated(scan, *before_) : scan);
  before_ = scan;
  if (!likelihood) {
    if (!started_) {
      return std::nullopt;
    }
    move(time_s, step);
    last_ns_ = scan.stamp_ns;
    return estimateOf(positions_, weights_);
  }
  const std::vector<double> probabilities = posterior(map_.places(), *likelihood);
  if (!started_ || (!step && time_s > config_.lost_after_s)) {
    start(probabilities);
  } else {
    // Errors of the map, and of a robot's body, stay alike on a short way. A robot that stands
    // still gains only the mean of its readings' noise.
    constexpr double kLeastExponent = 0.02;
    const double way_m = step ? step->norm() : map_.motion().speed * time_s;
    move(time_s, step);
    weigh(*likelihood, std::max(way_m / (way_m + config_.shared_way_m), kLeastExponent));
  }
  last_ns_ = scan.stamp_ns;
  const PlaceEstimate estimate = estimateOf(positions_, weights_);
  resample(probabilities);
  return estimate;
}

void ParticleFilter::start(const std::vector<double>& probabilities) {
  const std::vector<double> sums = sumsOf(probabilities);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    draw(i, sums);
    weights_[i] = 1.0;
  }
  started_ = true;
}

void ParticleFilter::draw(std::size_t particle, const std::vector<double>& sums) {
  const PlaceLattice& places = map_.places();
  const double half_m = 0.5 * places.edge();
  positions_[particle] =
      places.points()[drawn(sums, random_.uniform())] +
      Position(random_.uniform(-half_m, half_m), random_.uniform(-half_m, half_m));
  velocities_[particle] = drawnVelocity();
  yaws_rad_[particle] = random_.uniform(-config_.start_yaw, config_.start_yaw);
}

Position ParticleFilter::drawnVelocity() {
  const Motion& motion = map_.motion();
  const Position any = std::sqrt(0.5) * motion.speed * Position(random_.normal(), random_.normal());
  if (motion.velocities.empty()) {
    return any;
  }
  const auto count = static_cast<double>(motion.velocities.size());
  const auto number = static_cast<std::size_t>(random_.uniform(0.0, count));
  const Position& met = motion.velocities[std::min(number, motion.velocities.size() - 1)];
  return (random_.uniform() < 0.5 ? met : -met) + config_.velocity_spread * any;
}

void ParticleFilter::move(double time_s, const std::optional<Position>& step) {
  const double jitter = config_.velocity_jitter * map_.motion().speed * std::sqrt(time_s);
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (step) {
      const double length_m = step->norm();
      yaws_rad_[i] += config_.odometry_yaw_error * std::sqrt(length_m) * random_.normal();
      const double error_m = config_.odometry_error * length_m;
      positions_[i] += Eigen::Rotation2Dd(yaws_rad_[i]) * *step +
                       error_m * Position(random_.normal(), random_.normal());
      continue;
    }
    const double until_s = -map_.motion().velocity_time_s * std::log(random_.uniform());
    if (until_s < time_s) {
      positions_[i] += until_s * velocities_[i];
      velocities_[i] = drawnVelocity();
      positions_[i] += (time_s - until_s) * velocities_[i];
      continue;
    }
    velocities_[i] += jitter * Position(random_.normal(), random_.normal());
    positions_[i] += time_s * velocities_[i];
  }
}

void ParticleFilter::weigh(const std::vector<double>& log_likelihood, double exponent) {
  const PlaceLattice& places = map_.places();
  std::vector<double> logs(positions_.size());
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    // The prior keeps particles near the mapped path. Each way of shared errors applies it once.
    logs[i] = exponent * (places.interpolated(log_likelihood, positions_[i]) +
                          places.interpolated(places.logPrior(), positions_[i]));
    most = std::max(most, logs[i]);
  }
  if (!std::isfinite(most)) {
    return;  // all left the map; the next draw brings some back
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    weights_[i] *= std::exp(logs[i] - most);
    sum += weights_[i];
  }
  if (!(sum > 0.0)) {
    std::fill(weights_.begin(), weights_.end(), 1.0);
  }
}

void ParticleFilter::resample(const std::vector<double>& probabilities) {
  const double total = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  double squares = 0.0;
  for (double& weight : weights_) {
    weight /= total;
    squares += weight * weight;
  }
  const auto count = static_cast<double>(weights_.size());
  if (1.0 / squares < 0.5 * count) {
    // Systematic resampling: one random number, then even steps.
    const std::vector<double> sums = sumsOf(weights_);
    const std::vector<Position> positions = positions_;
    const std::vector<Position> velocities = velocities_;
    const std::vector<double> yaws_rad = yaws_rad_;
    const double offset = random_.uniform();
    std::size_t from = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double share = (static_cast<double>(i) + offset) / count * sums.back();
      while (from + 1 < sums.size() && sums[from] < share) {
        ++from;
      }
      positions_[i] = positions[from];
      velocities_[i] = velocities[from];
      yaws_rad_[i] = yaws_rad[from];
    }
    std::fill(weights_.begin(), weights_.end(), 1.0 / count);
    const std::vector<double> places = sumsOf(probabilities);
    const auto redrawn = static_cast<std::size_t>(std::lround(config_.redrawn * count));
    const std::size_t first = static_cast<std::size_t>(random_.uniform(0.0, count));
    for (std::size_t i = 0; i < redrawn; ++i) {
      draw((first + i) % weights_.size(), places);
    }
  }
}

}  // namespace sfw
