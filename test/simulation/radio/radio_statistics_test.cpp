// What the simulated signals claim is recovered from them. Bounds are four standard errors of the
// estimate, written as they follow from the number of samples; seeds are fixed.

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "support/moments.h"
#include "support/radio_hall.h"

namespace sfw {
namespace {

using test::accessPointAt;
using test::correlationOf;
using test::emptyHall;
using test::Moments;
using test::momentsOf;
using test::oneAt;
using test::quietRadio;

constexpr double kErrors = 4.0;  // standard errors that a bound allows

RobotPose at(const Position& place, double yaw_rad = 0.0) { return {place, yaw_rad}; }

/// Standard errors of estimates from n independent values.
double errorOfMean(double deviation, double n) { return deviation / std::sqrt(n); }
double errorOfDeviation(double deviation, double n) { return deviation / std::sqrt(2.0 * n); }

/// Least squares slope of z over h.
double slopeOf(const std::vector<double>& h, const std::vector<double>& z) {
  return correlationOf(h, z) * momentsOf(z).deviation / momentsOf(h).deviation;
}

TEST(RadioStatistics, Exponent) {
  RadioModel::Config config = quietRadio();
  config.exponent = 1.7;
  config.shadowing_db = 3.0;
  config.shadowing_distance_m = 0.6;
  config.sample_noise_db = 3.0;
  config.rssi_step_db = 1.0;
  const Position source(20.0, 20.0);
  const RadioModel radio(emptyHall(), oneAt(source), config);
  std::vector<double> h, z;
  for (int i = 0; i < 1000; ++i) {  // three correlation lengths apart, or more
    const Position place(1.0 + 2.45 * (i % 40), 0.6 + 1.6 * (i / 40));
    h.push_back(10.0 * std::log10((place - source).norm()));
    z.push_back(*radio.rssi(0, at(place), static_cast<std::uint64_t>(i)));
  }
  const double residual = std::sqrt(9.0 + 9.0 + 1.0 / 12.0);
  EXPECT_NEAR(-slopeOf(h, z), 1.7, kErrors * residual / momentsOf(h).deviation / std::sqrt(1000.0));
}

TEST(RadioStatistics, LossOfAWallByMaterial) {
  for (const Material material : {Material::kInteriorWall, Material::kOuterWall}) {
    RadioModel::Config config = quietRadio();
    config.interior_wall_loss_db = 6.1;
    config.outer_wall_loss_db = 12.2;
    config.shadowing_db = 3.0;
    config.shadowing_distance_m = 0.6;
    config.sample_noise_db = 3.0;
    config.rssi_step_db = 1.0;
    config.sensitivity_dbm = -119.0;
    FloorPlan plan = emptyHall();
    test::buildWall(plan, 50.0, 0.2, material);
    // As far before the wall's middle as behind it, so that distance cancels.
    const RadioModel radio(plan, oneAt({50.0 - 1e-6, 20.0}), config);
    std::vector<double> losses;
    for (int i = 0; i < 500; ++i) {
      const Position aside(2.0 + 1.9 * (i % 25), -18.0 + 1.9 * (i / 25));
      const auto sample = static_cast<std::uint64_t>(i);
      const Position source(50.0, 20.0);
      const double before = *radio.rssi(0, at(source + Position(-aside.x(), aside.y())), sample);
      losses.push_back(before - *radio.rssi(0, at(source + aside), sample + 1000));
    }
    const double truth = material == Material::kOuterWall ? 12.2 : 6.1;
    const double deviation = std::sqrt(2.0 * (9.0 + 9.0 + 1.0 / 12.0));
    EXPECT_NEAR(momentsOf(losses).mean, truth, kErrors * errorOfMean(deviation, 500.0));
  }
}

TEST(RadioStatistics, VariationFromWallToWall) {
  for (const Material material : {Material::kInteriorWall, Material::kOuterWall}) {
    RadioModel::Config config = quietRadio();
    config.interior_wall_loss_db = 8.0;
    config.interior_wall_variation_db = 1.0;
    config.outer_wall_loss_db = 16.0;
    config.outer_wall_variation_db = 2.0;
    FloorPlan plan = emptyHall();
    test::buildWall(plan, 50.0, 0.2, material);
    std::vector<double> here, near;
    for (config.seed = 0; config.seed < 150; ++config.seed) {
      const RadioModel radio(plan, oneAt({0.5, 20.0}), config);
      for (int i = 0; i < 9; ++i) {  // 4 m apart along the wall, two correlation lengths
        const double y = 4.0 * (i - 4);
        here.push_back(radio.obstacleLoss(0, {99.7, 20.0 + 2.0 * y}));
        near.push_back(radio.obstacleLoss(0, {99.7, 20.0 + 2.0 * (y + 2.0)}));
      }
    }
    const auto n = static_cast<double>(here.size());
    const double truth = material == Material::kOuterWall ? 2.0 : 1.0;
    EXPECT_NEAR(momentsOf(here).mean, 8.0 * truth, kErrors * errorOfMean(truth, n));
    EXPECT_NEAR(momentsOf(here).deviation, truth, kErrors * errorOfDeviation(truth, n));
    EXPECT_NEAR(correlationOf(here, near), std::exp(-1.0), kErrors / std::sqrt(n));
  }
}

TEST(RadioStatistics, Shadowing) {
  for (const double length : {0.6, 1.5}) {
    RadioModel::Config config = quietRadio();
    config.exponent = 0.0;
    config.shadowing_db = 3.7;
    config.shadowing_distance_m = length;
    std::vector<double> here, quarter, whole, twice, of_other;
    for (config.seed = 0; config.seed < 50; ++config.seed) {
      const RadioModel radio(
          emptyHall(), asTransmitters({accessPointAt({20, 20}), accessPointAt({20, 20})}), config);
      for (int i = 0; i < 100; ++i) {
        const Position place(2.0 + 9.0 * (i % 10), 1.0 + 3.7 * (i / 10));
        const Position step = length * Position(0.6, 0.8);
        here.push_back(radio.meanRssi(0, at(place)) - config.rssi_at_1m_dbm);
        quarter.push_back(radio.meanRssi(0, at(place + 0.25 * step)));
        whole.push_back(radio.meanRssi(0, at(place + step)));
        twice.push_back(radio.meanRssi(0, at(place + 2.0 * step)));
        of_other.push_back(radio.meanRssi(1, at(place)));
      }
    }
    // Places that are 3.7 m apart are as good as independent, also at 1.5 m: exp(-2.5) = 0.08.
    EXPECT_NEAR(momentsOf(here).mean, 0.0, kErrors * errorOfMean(3.7, 5000.0));
    EXPECT_NEAR(momentsOf(here).deviation, 3.7, kErrors * errorOfDeviation(3.7, 5000.0));
    const double bound = kErrors / std::sqrt(5000.0);
    EXPECT_NEAR(correlationOf(here, quarter), std::exp(-0.25), bound);
    EXPECT_NEAR(correlationOf(here, whole), std::exp(-1.0), bound);
    EXPECT_NEAR(correlationOf(here, twice), std::exp(-2.0), bound);
    EXPECT_NEAR(correlationOf(here, of_other), 0.0, bound);
  }
}

TEST(RadioStatistics, Fading) {
  RadioModel::Config config;
  config.sample_noise_db = 2.0;
  const RadioModel radio(emptyHall(), oneAt({10.0, 10.0}), config);
  const RobotPose pose = at({17.3, 12.1});
  std::vector<double> here, next;
  for (std::uint64_t sample = 0; sample < 20000; ++sample) {
    here.push_back(*radio.rssi(0, pose, sample) - radio.meanRssi(0, pose));
    next.push_back(*radio.rssi(0, pose, sample + 1));
  }
  const double deviation = std::sqrt(4.0 + 1.0 / 12.0);  // with the share of the 1 dB steps
  EXPECT_NEAR(momentsOf(here).mean, 0.0, kErrors * errorOfMean(deviation, 20000.0));
  EXPECT_NEAR(momentsOf(here).deviation, deviation, kErrors * errorOfDeviation(deviation, 20000.0));
  EXPECT_NEAR(correlationOf(here, next), 0.0, kErrors / std::sqrt(20000.0));
}

TEST(RadioStatistics, ShareOfMissedReadings) {
  RadioModel::Config config;
  config.missed_share = 0.3;
  const RadioModel radio(emptyHall(), oneAt({10.0, 10.0}), config);
  double heard = 0.0;
  for (std::uint64_t sample = 0; sample < 10000; ++sample) {
    heard += radio.rssi(0, at({12.0, 12.0}), sample) ? 1.0 : 0.0;
  }
  EXPECT_NEAR(heard / 10000.0, 0.7, kErrors * std::sqrt(0.3 * 0.7 / 10000.0));
}

/// Amplitude of a harmonic in signals that were heard all around, at even steps.
double harmonic(const std::vector<double>& signals, int order) {
  double cosine = 0.0, sine = 0.0;
  const auto n = static_cast<double>(signals.size());
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const double angle = 2.0 * kPi * order * static_cast<double>(i) / n;
    cosine += signals[i] * std::cos(angle);
    sine += signals[i] * std::sin(angle);
  }
  return 2.0 / n * std::hypot(cosine, sine);
}

/// A first and a second harmonic of 2 dB, and no third.
void expectPattern(const std::vector<double>& signals) {
  const double error = 2.0 * std::sqrt(2.0 / static_cast<double>(signals.size()));  // 2 dB fading
  EXPECT_NEAR(harmonic(signals, 1), 2.0, kErrors * error);
  EXPECT_NEAR(harmonic(signals, 2), 2.0, kErrors * error);
  EXPECT_NEAR(harmonic(signals, 3), 0.0, kErrors * error);
}

RadioModel::Config patternedRadio() {
  RadioModel::Config config = quietRadio();
  config.sample_noise_db = 2.0;
  config.access_point_pattern_db = 2.0;
  config.robot_pattern_db = 2.0;
  return config;
}

TEST(RadioStatistics, PatternOfTheAccessPoint) {
  const RadioModel radio(emptyHall(), oneAt({50, 20}), patternedRadio());
  std::vector<double> signals;
  for (int i = 0; i < 3600; ++i) {  // the robot always looks outwards, so its own gain is constant
    const double bearing = 2.0 * kPi * i / 3600.0;
    const Position place = Position(50, 20) + 5.0 * Position(std::cos(bearing), std::sin(bearing));
    signals.push_back(*radio.rssi(0, at(place, bearing), static_cast<std::uint64_t>(i)));
  }
  expectPattern(signals);
}

TEST(RadioStatistics, PatternOfTheRobotTurnsWithIt) {
  const RadioModel radio(emptyHall(), oneAt({50, 20}), patternedRadio());
  std::vector<double> signals;
  for (int i = 0; i < 3600; ++i) {
    const double yaw = 2.0 * kPi * i / 3600.0;
    signals.push_back(*radio.rssi(0, at({54, 23}, yaw), static_cast<std::uint64_t>(i)));
  }
  expectPattern(signals);
}

TEST(RadioStatistics, PatternsHaveTheirAmplitudeAsDeviation) {
  RadioModel::Config config = patternedRadio();
  config.access_point_pattern_db = 0.0;
  const RadioModel radio(emptyHall(), oneAt({50, 20}), config);
  std::vector<double> gains;
  for (int i = 0; i < 360; ++i) {
    gains.push_back(radio.meanRssi(0, at({54, 23}, 2.0 * kPi * i / 360.0)));
  }
  EXPECT_NEAR(momentsOf(gains).deviation, 2.0, 1e-9);
}

}  // namespace
}  // namespace sfw
