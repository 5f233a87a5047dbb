#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "base/random.h"
#include "grid/for_each_cell.h"
#include "radio/path_loss.h"
#include "tomography/line_field.h"

namespace sfw::test {

/// A straight wall across one axis: at `x` for all y between `from` and `to` if it is across x.
struct StraightWall {
  bool walls_along_y = true;
  double at = 0.0;
  double from = 0.0;
  double to = 0.0;
  double loss_db = 0.0;
};

inline bool crosses(const StraightWall& wall, Position a, Position b) {
  if (!wall.walls_along_y) {
    a.reverseInPlace();
    b.reverseInPlace();
  }
  if ((a.x() < wall.at) == (b.x() < wall.at)) {
    return false;
  }
  const double y = a.y() + (wall.at - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
  return y >= wall.from && y <= wall.to;
}

/// Bins of an access point behind walls, with path loss of exponent 2 from -35 dBm at 1 m.
inline AccessPointBins binsThrough(const std::vector<StraightWall>& walls,
                                   const Position& access_point,
                                   const std::vector<Position>& places,
                                   double saturation_db = std::numeric_limits<double>::infinity(),
                                   double noise_db = 0.0) {
  AccessPointBins behind;
  behind.position = access_point;
  behind.noise_db2 = 0.09 + noise_db * noise_db;
  Random random(1, 1, static_cast<std::uint64_t>(places.size()));
  for (const Position& place : places) {
    double loss = 0.0;
    for (const StraightWall& wall : walls) {
      loss += crosses(wall, access_point, place) ? wall.loss_db : 0.0;
    }
    if (std::isfinite(saturation_db)) {
      loss = saturation_db * (1.0 - std::exp(-loss / saturation_db));
    }
    const double rssi =
        -35.0 - 2.0 * logDistance(behind, place) - loss + noise_db * random.normal();
    behind.bins.push_back({place, rssi, 1.0});
  }
  return behind;
}

/// Places 0.2 m apart along a polyline.
inline std::vector<Position> placesAlong(const std::vector<Position>& corners) {
  std::vector<Position> places;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Position along = corners[i] - corners[i - 1];
    const int steps = std::max(1, static_cast<int>(std::lround(along.norm() / 0.2)));
    for (int step = 0; step < steps; ++step) {
      places.push_back(corners[i - 1] + along * step / steps);
    }
  }
  return places;
}

/// Cells that the robot covers within a radius of its places.
inline Mask coveredBy(const GridGeometry& geometry, const std::vector<Position>& places,
                      double radius) {
  Mask mask(geometry);
  forEachCell(geometry, [&](Cell c) {
    mask[c] = std::any_of(places.begin(), places.end(), [&](const Position& place) {
      return (geometry.centre(c) - place).norm() <= radius;
    });
  });
  return mask;
}

}  // namespace sfw::test
