#pragma once

#include <cmath>

#include "simulation/radio/radio_model.h"

namespace sfw::test {

/// A hall of 100 x 40 m, in cells of 0.1 m, with nothing in it.
inline FloorPlan emptyHall() {
  return FloorPlan(GridGeometry(0.1, Position::Zero(), 1000, 400), Material::kFree);
}

/// Builds a wall across a hall.
inline void buildWall(FloorPlan& plan, double from_x_m, double thickness_m, Material material) {
  const double resolution = plan.geometry.resolution();
  const auto first = static_cast<std::int64_t>(std::lround(from_x_m / resolution));
  const auto cells = static_cast<std::int64_t>(std::lround(thickness_m / resolution));
  Cell c;
  for (c.y = 0; c.y < plan.geometry.height(); ++c.y) {
    for (c.x = first; c.x < first + cells; ++c.x) {
      plan[c] = material;
    }
  }
}

/// The hall with an interior wall a metre thick from x = 50 to 51.
inline FloorPlan dividedHall() {
  FloorPlan plan = emptyHall();
  buildWall(plan, 50.0, 1.0, Material::kInteriorWall);
  return plan;
}

inline AccessPoint accessPointAt(const Position& position,
                                 const char* bssid = "02:00:00:00:00:01") {
  AccessPoint access_point;
  access_point.bssid = *Bssid::parse(bssid);
  access_point.position = position;
  return access_point;
}

/// One access point on 2.4 GHz.
inline std::vector<Transmitter> oneAt(const Position& position) {
  return asTransmitters({accessPointAt(position)});
}

/// Settings without randomness and rounding.
inline RadioModel::Config quietRadio() {
  RadioModel::Config config;
  config.shadowing_db = 0.0;
  config.sample_noise_db = 0.0;
  config.rssi_step_db = 0.0;
  return config;
}

}  // namespace sfw::test
