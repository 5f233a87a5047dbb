#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "localization/scan.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A hall of 20 x 12 m with eight radios at its walls, each with some names of its own.
struct HeardHall {
  int names = 1;  // BSSIDs of each radio; they share fading
  double noise_db = 3.0;
  std::int64_t seed = 1;

  static Bssid bssid(int radio, int name) {
    const char digits[] = "0123456789abcdef";
    std::string text = "02:00:00:00:00:00";
    text[12] = digits[radio];
    text[16] = digits[name];
    return *Bssid::parse(text);
  }

  static Position placeOf(int radio) { return {radio % 4 * 6.0 + 1.0, radio < 4 ? -1.0 : 13.0}; }

  /// Signals fall with distance; a wave of the floor stands for walls and furniture.
  static double meanDbm(int radio, const Position& at) {
    const double distance = std::hypot((at - placeOf(radio)).norm(), 1.0);
    return -38.0 - 28.0 * std::log10(distance) +
           3.0 * std::sin(0.9 * at.x() + radio) * std::cos(0.7 * at.y() - radio);
  }

  Scan scanAt(const Position& at, double stamp_s) const {
    Random random(seed, 77, static_cast<std::uint64_t>(std::llround(1e3 * stamp_s)));
    Scan scan;
    scan.stamp_ns = std::llround(1e9 * stamp_s);
    scan.position = at;
    for (int radio = 0; radio < 8; ++radio) {
      const double rssi_dbm = meanDbm(radio, at) + noise_db * random.normal();
      for (int name = 0; name < names; ++name) {
        scan.heard.emplace_back(bssid(radio, name), rssi_dbm + 0.3 * random.normal());
      }
    }
    return scan;
  }

  /// Along lanes of 20 m at 0.5 m/s, a scan each second.
  std::vector<Scan> drive(double first_lane_m, double lane_step_m, double start_s) const {
    std::vector<Scan> scans;
    bool back = false;
    double time_s = start_s;
    for (double y = first_lane_m; y <= 12.0; y += lane_step_m, back = !back) {
      for (int step = 0; step <= 40; ++step, time_s += 1.0) {
        scans.push_back(scanAt({back ? 20.0 - 0.5 * step : 0.5 * step, y}, time_s));
      }
    }
    return scans;
  }
};

}  // namespace sfw
