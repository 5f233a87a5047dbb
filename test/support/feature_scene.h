#pragma once

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "belief/cell_features.h"
#include "support/ascii_world.h"
#include "support/number_table.h"

namespace sfw::test {

using Picture = std::vector<std::string>;

/// A drive drawn as a picture, top row first: '#' and small letters are cells of the path. Letters
/// are also the positions driven, in alphabetical order. 'X' marks the cell under test.
struct FeatureScene {
  Picture path;
  double resolution_m = 0.5;
  Picture wall_db = {};  ///< digits: strength of the wall in each cell [dB]
  std::vector<AccessPointBins> access_points = {};
  std::vector<std::vector<double>> ray_loss_db = {};  ///< of each bin of each access point
  double robot_radius_m = 0.15;
  double max_gap_m = 1.0;
};

inline GridGeometry geometryOf(const FeatureScene& scene) {
  return GridGeometry(scene.resolution_m, Position::Zero(),
                      static_cast<std::int64_t>(scene.path.front().size()),
                      static_cast<std::int64_t>(scene.path.size()));
}

/// Centre of a cell that is counted from the left and from the bottom.
inline Position centre(const FeatureScene& scene, std::int64_t x, std::int64_t y) {
  return geometryOf(scene).centre({x, y});
}

/// An access point in the middle of a cell, with a bin in the middle of each of some others.
inline AccessPointBins accessPointAt(const FeatureScene& scene, Cell at,
                                     const std::vector<Cell>& bins) {
  AccessPointBins access_point;
  access_point.position = centre(scene, at.x, at.y);
  for (const Cell bin : bins) {
    access_point.bins.push_back({centre(scene, bin.x, bin.y), -50.0, 1.0});
  }
  return access_point;
}

inline bool isDriven(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }

/// The positions of a picture's letters; those of its '#' if it has no letter.
inline std::vector<Position> drivenIn(const FeatureScene& scene) {
  const Grid<char> cells = gridFrom<char>(scene.path, scene.resolution_m, [](char c) { return c; });
  std::multimap<char, Position> in_order;
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    in_order.emplace(cells.cells[i], cells.geometry.centre(cells.geometry.cell(i)));
  }
  std::vector<Position> letters;
  std::vector<Position> others;
  for (const auto& [name, position] : in_order) {
    if (isDriven(name)) {
      letters.push_back(position);
    } else if (name == '#') {
      others.push_back(position);
    }
  }
  return letters.empty() ? others : letters;
}

inline CellFeatures described(const FeatureScene& scene,
                              const ExplainedVarianceLimits& limits = {}) {
  const Mask path = gridFrom<std::uint8_t>(
      scene.path, scene.resolution_m,
      [](char c) -> std::uint8_t { return c == '#' || isDriven(c) ? 1 : 0; });
  Grid<float> strength(path.geometry);
  if (!scene.wall_db.empty()) {
    strength = gridFrom<float>(scene.wall_db, scene.resolution_m, [](char c) {
      return c >= '0' && c <= '9' ? static_cast<float>(c - '0') : 0.0F;
    });
  }
  const std::atomic<bool> never{false};
  return extractCellFeatures({path, drivenIn(scene), scene.max_gap_m, scene.robot_radius_m},
                             scene.access_points, {{}, strength, scene.ray_loss_db}, never, limits);
}

/// One feature of all cells; not a number where a cell is not described.
inline Grid<float> featureOf(const CellFeatures& features, const std::string& name) {
  const CellFeature* const row =
      std::find_if(std::begin(kCellFeatureTable), std::end(kCellFeatureTable),
                   [&](const CellFeature& feature) { return feature.name == name; });
  if (row == std::end(kCellFeatureTable)) {
    throw std::invalid_argument("no feature is called " + name);
  }
  const auto at = static_cast<std::size_t>(row - std::begin(kCellFeatureTable));
  Grid<float> values(features.geometry, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < features.cells.size(); ++i) {
    values.cells[features.cells[i]] = features.values[i][at];
  }
  return values;
}

inline Grid<float> featureOf(const FeatureScene& scene, const std::string& name) {
  return featureOf(described(scene), name);
}

/// A feature of the cell marked 'X'.
inline double featureAtX(const FeatureScene& scene, const std::string& name) {
  const Grid<char> cells = gridFrom<char>(scene.path, scene.resolution_m, [](char c) { return c; });
  const auto marked = std::find(cells.cells.begin(), cells.cells.end(), 'X');
  const auto index = static_cast<std::size_t>(marked - cells.cells.begin());
  return static_cast<double>(featureOf(scene, name).cells.at(index));
}

/// '#' where a value is positive, '.' where it is not, ' ' where there is none.
inline Picture positiveIn(const Grid<float>& values) {
  return rowsOf(values, [](float value) {
    return std::isnan(value) ? ' ' : value > 0.0F ? '#' : '.';
  });
}

}  // namespace sfw::test
