#include "cli/far_positions.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kFar = 2e3;     // [m]; no building is so large, and no OctoMap
constexpr double kStep = 100.0;  // [m]; keeps cells on the lattice of the user's frame

double medianAlong(const std::vector<Reading>& readings, int axis) {
  std::vector<double> values;
  values.reserve(readings.size());
  for (const Reading& reading : readings) {
    values.push_back(reading.antenna_in_map[axis]);
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Position offsetOf(const std::vector<Reading>& readings) {
  if (readings.empty()) {
    return Position::Zero();
  }
  const Position middle(medianAlong(readings, 0), medianAlong(readings, 1));
  if (!(middle.cwiseAbs().maxCoeff() > kFar)) {
    return Position::Zero();
  }
  return kStep * (middle / kStep).array().floor();
}

Position near(const Position& point, const Position& offset) {
  constexpr double kMicrometres = 1e6;
  return offset.isZero()
             ? point
             : Position(((point - offset) * kMicrometres).array().round() / kMicrometres);
}

void subtract(const Position& offset, std::vector<Reading>& readings) {
  for (Reading& reading : readings) {
    reading.antenna_in_map = near(reading.antenna_in_map, offset);
  }
}

void subtract(const Position& offset, std::vector<AccessPoint>& access_points) {
  for (AccessPoint& access_point : access_points) {
    if (access_point.position_known) {
      access_point.position = near(access_point.position, offset);
    }
  }
}

void requireSameFrame(const Position& offset, const std::vector<AccessPoint>& access_points,
                      const std::string& table_file) {
  for (const AccessPoint& access_point : access_points) {
    if (offset.isZero() || !access_point.position_known ||
        access_point.position.cwiseAbs().maxCoeff() <= kFar) {
      continue;
    }
    const Position given = access_point.position + offset;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << table_file << ": " << access_point.bssid.str()
         << " lies at (" << given.x() << ", " << given.y() << "), but the readings near ("
         << offset.x() << ", " << offset.y()
         << "); give both in one frame, or leave out x and y of the access point";
    throw InputError(text.str());
  }
}

}  // namespace sfw
