#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "k_visibility/sparse_inverse.h"
#include "support/ascii_world.h"

namespace sfw::test {

/// Settings for readable pictures with cells of 1 m. A wall is a cell thick, and the robot covers
/// one cell. Neighbouring poses are not joined.
inline SparseInverseConfig coarseSettings() {
  SparseInverseConfig settings;
  settings.footprint_radius_m = 0.4;
  settings.max_gap_m = 0.5;
  settings.wall_thickness_m = 1.0;
  settings.wall_prior = 0.2;
  return settings;
}

/// The poses of one access point, drawn on cells of 1 m. 'R' is the access point. A digit is a pose
/// with that number of walls.
inline CountedPath countedIn(const std::vector<std::string>& rows) {
  CountedPath counted;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t x = 0; x < rows[row].size(); ++x) {
      const char c = rows[row][x];
      const Position centre(static_cast<double>(x) + 0.5,
                            static_cast<double>(rows.size() - row) - 0.5);
      if (c == 'R') {
        counted.access_point = centre;
      } else if (c >= '0' && c <= '9') {
        counted.poses.push_back({centre, c - '0'});
      }
    }
  }
  return counted;
}

inline std::vector<Position> pathOf(const std::vector<CountedPath>& counted) {
  std::vector<Position> path;
  for (const CountedPath& one : counted) {
    for (const CountedPose& pose : one.poses) {
      path.push_back(pose.antenna_in_map);
    }
  }
  return path;
}

inline Grid<float> inferred(const GridGeometry& geometry, const std::vector<CountedPath>& counted,
                            const SparseInverseConfig& settings = coarseSettings(),
                            const std::vector<Contact>& contacts = {}) {
  const std::atomic<bool> never{false};
  return inferOccupancy(geometry, counted, pathOf(counted), contacts, settings, never);
}

/// The map of one access point's picture.
inline Grid<float> inferred(const std::vector<std::string>& rows,
                            const SparseInverseConfig& settings = coarseSettings(),
                            const std::vector<Contact>& contacts = {}) {
  const GridGeometry geometry(1.0, {0.0, 0.0}, static_cast<std::int64_t>(rows.front().size()),
                              static_cast<std::int64_t>(rows.size()));
  return inferred(geometry, {countedIn(rows)}, settings, contacts);
}

/// '.' free, '#' occupied, '?' unknown by the default thresholds.
inline std::vector<std::string> rowsOf(const Grid<float>& occupied) {
  const Config::Belief belief;
  return rowsOf(occupied, [&](float p) {
    return p < belief.free_threshold ? '.' : p > belief.occupied_threshold ? '#' : '?';
  });
}

}  // namespace sfw::test
