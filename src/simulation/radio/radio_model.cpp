#include "simulation/radio/radio_model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/constants.h"
#include "base/limited_loss.h"
#include "base/random.h"
#include "base/random_streams.h"
#include "base/validation.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kUsualTxDbm = 20.0;              // for which rssi_at_1m holds
constexpr double kWallCorrelationDistance = 2.0;  // of a wall's loss, 1/e [m]
constexpr double kAreaPerFurniture = 9.0;         // [m2]
constexpr double kMinDistance = 0.1;              // the model is not valid at smaller distances [m]

std::string outsideText(const AccessPoint& access_point) {
  char text[64];
  std::snprintf(text, sizeof text, " at (%.2f, %.2f) is outside the plan",
                access_point.position.x(), access_point.position.y());
  return "access point " + access_point.bssid.str() + text;
}

/// @throw InputError
void requireUsable(const FloorPlan& plan, const std::vector<Transmitter>& transmitters,
                   const RadioModel::Config& config) {
  std::vector<std::string> problems = validate(config);
  for (const Transmitter& transmitter : transmitters) {
    if (!plan.geometry.contains(plan.geometry.cellAt(transmitter.access_point.position))) {
      problems.push_back(outsideText(transmitter.access_point));
    }
  }
  throwIfAny(problems);
}

}  // namespace

double frequencyMhz(Band band) { return band == Band::k2400MHz ? 2437.0 : 5180.0; }

BandFigures bandFigures(Band band) {
  if (band == Band::k2400MHz) {
    return {0.0, 1.0, 1.0};
  }
  return {6.55, 1.0, 1.8};
}

std::vector<Transmitter> asTransmitters(const std::vector<AccessPoint>& access_points, Band band) {
  std::vector<Transmitter> sending;
  sending.reserve(access_points.size());
  for (const AccessPoint& access_point : access_points) {
    sending.push_back({access_point, band});
  }
  return sending;
}

RadioModel::AntennaPattern::AntennaPattern(double amplitude, std::int64_t seed,
                                           std::uint64_t stream)
    : amplitude_db(amplitude) {
  Random random(seed, stream, 0);
  first_phase_rad = 2.0 * kPi * random.uniform();
  second_phase_rad = 2.0 * kPi * random.uniform();
}

double RadioModel::AntennaPattern::gain(double bearing_rad) const {
  return amplitude_db *
         (std::cos(bearing_rad + first_phase_rad) + std::cos(2.0 * bearing_rad + second_phase_rad));
}

RadioModel::RadioModel(const FloorPlan& plan, const std::vector<Transmitter>& transmitters,
                       const Config& config)
    : plan_((requireUsable(plan, transmitters, config), plan)),
      transmitters_(transmitters),
      config_(config),
      wall_variation_(RandomField::Kind::kSmooth, kWallCorrelationDistance, config.seed,
                      streamOf(Purpose::kWallVariation)),
      robot_pattern_(config.robot_pattern_db, config.seed, streamOf(Purpose::kRobotPattern)) {
  if (config.max_furniture_loss_db > 0.0) {
    furniture_ = placeFurniture(plan, config.max_furniture_loss_db, kAreaPerFurniture, config.seed);
  }
  for (std::size_t i = 0; i < transmitters.size(); ++i) {
    shadowing_.emplace_back(RandomField::Kind::kRough, config.shadowing_distance_m, config.seed,
                            streamOf(Purpose::kShadowing, i));
    access_point_patterns_.emplace_back(config.access_point_pattern_db, config.seed,
                                        streamOf(Purpose::kAccessPointPattern, i));
  }
}

double RadioModel::wallLoss(const WallCrossing& wall, Band band) const {
  const bool outer = wall.material == Material::kOuterWall;
  const BandFigures on_band = bandFigures(band);
  const double factor = outer ? on_band.outer_wall_factor : on_band.interior_wall_factor;
  const double mean = outer ? config_.outer_wall_loss_db : config_.interior_wall_loss_db;
  const double variation =
      outer ? config_.outer_wall_variation_db : config_.interior_wall_variation_db;
  const double here = variation > 0.0 ? mean + variation * wall_variation_.at(wall.middle) : mean;
  return factor * std::max(here, 0.0);
}

double RadioModel::obstacleLoss(std::size_t access_point, const Position& antenna_in_map) const {
  const Transmitter& source = transmitters_[access_point];
  const Position& from = source.access_point.position;
  double loss_db = furnitureLoss(furniture_, from, antenna_in_map);
  for (const WallCrossing& wall : wallsBetween(plan_, from, antenna_in_map)) {
    loss_db += wallLoss(wall, source.band);
  }
  return limitedLoss(loss_db, config_.max_obstacle_loss_db);
}

int RadioModel::wallCount(std::size_t access_point, const Position& antenna_in_map) const {
  return countWalls(plan_, transmitters_[access_point].access_point.position, antenna_in_map);
}

double RadioModel::meanRssi(std::size_t access_point, const RobotPose& robot_in_map) const {
  const Transmitter& transmitter = transmitters_[access_point];
  const AccessPoint& source = transmitter.access_point;
  const Position to_robot = robot_in_map.position - source.position;
  const double above =
      source.height_m.value_or(config_.antenna_height_m) - config_.antenna_height_m;
  const double distance = std::max(std::hypot(to_robot.norm(), above), kMinDistance);
  const double bearing = std::atan2(to_robot.y(), to_robot.x());
  const double seen_from_robot = bearing + kPi - robot_in_map.yaw_rad;
  double rssi_dbm = config_.rssi_at_1m_dbm + source.tx_dbm.value_or(kUsualTxDbm) - kUsualTxDbm;
  rssi_dbm -= bandFigures(transmitter.band).loss_at_1m_db;
  rssi_dbm -= 10.0 * config_.exponent * std::log10(distance);
  rssi_dbm -= obstacleLoss(access_point, robot_in_map.position);
  if (config_.shadowing_db > 0.0) {
    rssi_dbm += config_.shadowing_db * shadowing_[access_point].at(robot_in_map.position);
  }
  rssi_dbm += access_point_patterns_[access_point].gain(bearing);
  return rssi_dbm + robot_pattern_.gain(seen_from_robot);
}

std::optional<double> RadioModel::rssi(std::size_t access_point, const RobotPose& robot_in_map,
                                       std::uint64_t sample) const {
  if (Random(config_.seed, streamOf(Purpose::kMisses, access_point), sample).uniform() <=
      config_.missed_share) {
    return std::nullopt;
  }
  Random random(config_.seed, streamOf(Purpose::kFading, access_point), sample);
  double rssi_dbm =
      meanRssi(access_point, robot_in_map) + config_.sample_noise_db * random.normal();
  if (config_.rssi_step_db > 0.0) {
    rssi_dbm = config_.rssi_step_db * std::round(rssi_dbm / config_.rssi_step_db);
  }
  return rssi_dbm < config_.sensitivity_dbm ? std::nullopt
                                            : std::optional<double>(std::min(rssi_dbm, 0.0));
}

std::vector<std::string> validate(const RadioModel::Config& config) {
  Problems problems;
  constexpr double kMostLoss = 100.0, kMostDeviation = 30.0;
  problems.within("rssi_at_1m", config.rssi_at_1m_dbm, -119.0, 0.0);
  problems.within("exponent", config.exponent, 0.0, 10.0);
  problems.within("interior_wall_loss", config.interior_wall_loss_db, 0.0, kMostLoss);
  problems.within("interior_wall_variation", config.interior_wall_variation_db, 0.0,
                  kMostDeviation);
  problems.within("outer_wall_loss", config.outer_wall_loss_db, 0.0, kMostLoss);
  problems.within("outer_wall_variation", config.outer_wall_variation_db, 0.0, kMostDeviation);
  problems.within("saturation", config.max_obstacle_loss_db, 0.0, 1000.0);
  problems.within("shadowing", config.shadowing_db, 0.0, kMostDeviation);
  problems.within("shadowing_distance", config.shadowing_distance_m, 0.01, 1000.0);
  problems.within("sample_noise", config.sample_noise_db, 0.0, kMostDeviation);
  problems.within("access_point_pattern", config.access_point_pattern_db, 0.0, kMostDeviation);
  problems.within("robot_pattern", config.robot_pattern_db, 0.0, kMostDeviation);
  problems.within("furniture", config.max_furniture_loss_db, 0.0, kMostLoss);
  problems.within("step", config.rssi_step_db, 0.0, 10.0);
  problems.within("antenna_height", config.antenna_height_m, 0.0, 10.0);
  problems.within("sensitivity", config.sensitivity_dbm, -119.0, 0.0);
  problems.within("missed", config.missed_share, 0.0, 1.0);
  return problems.list();
}

}  // namespace sfw
