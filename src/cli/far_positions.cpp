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

/// The median of the readings along an axis, and their extent without the outermost twentieths.
struct Spread {
  double median;
  double extent;
};

Spread spreadAlong(const std::vector<Reading>& readings, int axis) {
  std::vector<double> values;
  values.reserve(readings.size());
  for (const Reading& reading : readings) {
    values.push_back(reading.antenna_in_map[axis]);
  }
  const auto at = [&](std::size_t twentieths) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * twentieths / 20);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  return {at(10), at(19) - at(1)};
}

}  // namespace

Position offsetOf(const std::vector<Reading>& readings) {
  if (readings.empty()) {
    return Position::Zero();
  }
  const Spread x = spreadAlong(readings, 0);
  const Spread y = spreadAlong(readings, 1);
  const Position middle(x.median, y.median);
  const double away = middle.cwiseAbs().maxCoeff();
  constexpr double kMuch = 10.0;  // of the extent; less is another unit, such as millimetres
  if (!(away > kFar && away > kMuch * std::max(x.extent, y.extent))) {
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
