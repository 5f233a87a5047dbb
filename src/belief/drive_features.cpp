#include "belief/drive_features.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "base/map_too_large.h"
#include "grid/ray.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Access points farther from the path than this do not enlarge the grid [m]: they shape no walls
/// near the path.
constexpr double kFarthestAccessPoint = 30.0;

/// A grid that covers every described cell and the access points nearby.
GridGeometry buildingGeometry(const std::vector<Position>& driven,
                              const std::vector<AccessPointBins>& access_points,
                              const Config::Map& config) {
  Box driven_box;
  for (const Position& position : driven) {
    driven_box.extend(position);
  }
  constexpr double kMargin = 0.5;  // [m]
  const auto grown = [](const Box& box, double by) {
    return Box(box.min() - Position(by, by), box.max() + Position(by, by));
  };
  Box box = grown(driven_box, kMaxDistanceToPath + kMargin);
  for (const AccessPointBins& one : access_points) {
    if (driven_box.exteriorDistance(one.position) < kFarthestAccessPoint) {
      box.extend(grown(Box(one.position), kMargin));
    }
  }
  try {
    return GridGeometry::covering(box, config.resolution_m, config.resolution_m,
                                  4 * config.max_cells);
  } catch (const std::invalid_argument&) {
    throw InputError(tooLargeText(driven_box, config));
  }
}

WallFieldConfig wallFieldConfig(const Config::Tomography& config) {
  WallFieldConfig walls;
  walls.line.max_total_wall_loss_db = config.max_total_wall_loss_db > 0.0
                                          ? config.max_total_wall_loss_db
                                          : std::numeric_limits<double>::infinity();
  walls.line.l1_weight = config.l1_weight;
  walls.line.smoothness_weight = config.smoothness_weight;
  walls.line.covariance.nugget_db2 = config.nugget_db * config.nugget_db;
  walls.wall_directions = static_cast<int>(config.wall_directions);
  walls.ensemble_size = static_cast<int>(config.ensemble_size);
  return walls;
}

}  // namespace

Mask cellsCrossed(const GridGeometry& geometry, const std::vector<Position>& driven,
                  double max_gap_m) {
  Mask cells(geometry);
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const Position& from = driven[i];
    const Position& next = driven[std::min(i + 1, driven.size() - 1)];
    const Position& to = (next - from).norm() > max_gap_m ? from : next;
    Ray(geometry, from, to).forEachCell([&](Cell c) {
      if (geometry.contains(c)) {
        cells[c] = 1;
      }
    });
  }
  return cells;
}

DriveFeatures extractDriveFeatures(const DriveData& drive, const Config& config,
                                   const std::atomic<bool>& stop,
                                   const ExplainedVarianceLimits& limits, KeptFeatures* kept) {
  const BuildingFrame frame = findBuildingFrame(drive.path, config.path.max_gap_m);
  std::vector<Position> driven;
  driven.reserve(drive.path.size());
  const Eigen::Matrix2d to_building = frame.toBuildingAxes();
  for (const Position& position : drive.path) {
    driven.emplace_back(to_building * position);
  }
  std::vector<AccessPointBins> access_points;
  for (const AccessPointSamples& one : drive.access_points) {
    access_points.push_back(binSamples(one.samples, one.access_point_in_map, one.height_m, frame,
                                       config.tomography.bin_size_m));
    access_points.back().covariance = frame.toBuilding(one.covariance_in_map);
  }
  const GridGeometry geometry = buildingGeometry(driven, access_points, config.map);
  Mask crossed = cellsCrossed(geometry, driven, config.path.max_gap_m);
  DrivenPath path{std::move(crossed), std::move(driven), config.path.max_gap_m,
                  config.path.footprint_radius_m};
  const WallFieldConfig wall_config = wallFieldConfig(config.tomography);
  WallField walls = kept == nullptr
                        ? estimateWalls(geometry, access_points, path.cells, path.robot_radius_m,
                                        wall_config, stop)
                        : refreshWalls({frame.yaw_rad, access_points, path.cells},
                                       path.robot_radius_m, wall_config, stop, kept->walls);
  CellFeatures cells = extractCellFeatures(path, access_points, walls, stop, limits);
  return {frame, std::move(access_points), std::move(walls), std::move(cells), std::move(path)};
}

}  // namespace sfw
