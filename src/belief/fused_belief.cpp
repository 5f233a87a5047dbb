#include "belief/fused_belief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/map_too_large.h"
#include "belief/free_and_rim.h"
#include "belief/free_probability.h"
#include "grid/ray.h"
#include "grid/robot_evidence.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

/// Access points farther than this from the way shape no walls near it [m].
constexpr double kFarthestAccessPoint = 30.0;

/// Shares of the signals that walls explain, as far as the belief reckons with them: a little above
/// the median of the training drives (.5), and what one of ten or twenty of them passes. Signals at
/// wrong places explain too little and would make it doubt all it knows from the path; few readings
/// of many walls explain too much.
constexpr double kLeastExplained = 0.55;
constexpr double kMostExplained = 0.7;

GridGeometry buildingGeometry(const std::vector<Position>& driven,
                              const std::vector<AccessPointBins>& heard,
                              const Config::Map& config) {
  Box way;
  for (const Position& position : driven) {
    way.extend(position);
  }
  constexpr double kAround = 0.5;  // [m]
  const auto grown = [](const Box& box, double by) {
    return Box(box.min() - Position(by, by), box.max() + Position(by, by));
  };
  Box box = grown(way, kMaxDistanceToPath + kAround);
  for (const AccessPointBins& one : heard) {
    if (way.exteriorDistance(one.position) < kFarthestAccessPoint) {
      box.extend(grown(Box(one.position), kAround));
    }
  }
  try {
    return GridGeometry::covering(box, config.resolution_m, config.resolution_m,
                                  4 * config.max_cells);
  } catch (const std::invalid_argument&) {
    throw InputError(tooLargeText(way, config));
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

DrivenPath drivenPath(const GridGeometry& geometry, std::vector<Position> driven,
                      const Config::Path& config) {
  DrivenPath path{Mask(geometry), std::move(driven), config.max_gap_m, config.footprint_radius_m};
  for (std::size_t i = 0; i < path.driven.size(); ++i) {
    const Position& from = path.driven[i];
    const Position& next = path.driven[std::min(i + 1, path.driven.size() - 1)];
    const Position& to = (next - from).norm() > config.max_gap_m ? from : next;
    Ray(geometry, from, to).forEachCell([&](Cell c) {
      if (geometry.contains(c)) {
        path.cells[c] = 1;
      }
    });
  }
  return path;
}

/// Linear in between the centres of the four nearest cells; `outside` beyond the grid.
float interpolated(const Grid<float>& values, const Position& place, float outside) {
  const GridGeometry& geometry = values.geometry;
  const Position at = geometry.toCells(place) - Position(0.5, 0.5);
  const Cell low{static_cast<std::int64_t>(std::floor(at.x())),
                 static_cast<std::int64_t>(std::floor(at.y()))};
  const auto x = static_cast<float>(at.x() - static_cast<double>(low.x));
  const auto y = static_cast<float>(at.y() - static_cast<double>(low.y));
  const auto value = [&](std::int64_t dx, std::int64_t dy) {
    const Cell c{low.x + dx, low.y + dy};
    return geometry.contains(c) ? values[c] : outside;
  };
  return (1.0F - y) * ((1.0F - x) * value(0, 0) + x * value(1, 0)) +
         y * ((1.0F - x) * value(0, 1) + x * value(1, 1));
}

/// Carries a grid of the building frame over to the map's.
Grid<float> onMap(const GridGeometry& geometry, const Grid<float>& values,
                  const BuildingFrame& frame, float outside) {
  Grid<float> result(geometry, outside);
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const Position place = frame.toBuilding(geometry.centre(geometry.cell(i)));
    result.cells[i] = interpolated(values, place, outside);
  }
  return result;
}

std::vector<std::vector<double>> sampleLosses(const DriveData& drive,
                                              const DriveFeatures& described) {
  std::vector<std::vector<double>> losses;
  for (std::size_t i = 0; i < drive.heard.size(); ++i) {
    losses.emplace_back();
    for (const Sample& sample : drive.heard[i].samples) {
      losses.back().push_back(lossBetween(described.walls, described.heard[i].position,
                                          described.frame.toBuilding(sample.antenna_in_map)));
    }
  }
  return losses;
}

}  // namespace

DriveFeatures extractDriveFeatures(const DriveData& drive, const Config& config,
                                   const std::atomic<bool>& stop) {
  const BuildingFrame frame = findBuildingFrame(drive.path, config.path.max_gap_m);
  std::vector<Position> driven;
  driven.reserve(drive.path.size());
  for (const Position& position : drive.path) {
    driven.push_back(frame.toBuilding(position));
  }
  std::vector<AccessPointBins> heard;
  for (const AccessPointSamples& one : drive.heard) {
    heard.push_back(binSamples(one.samples, one.access_point_in_map, one.height_m, frame,
                               config.tomography.bin_size_m));
  }
  const GridGeometry geometry = buildingGeometry(driven, heard, config.map);
  const DrivenPath path = drivenPath(geometry, std::move(driven), config.path);
  WallField walls = estimateWalls(geometry, heard, path.cells, path.robot_radius_m,
                                  wallFieldConfig(config.tomography), stop);
  CellFeatures cells = extractCellFeatures(path, heard, walls, stop);
  return {frame, std::move(heard), std::move(walls), std::move(cells)};
}

FusedBelief inferOccupancyByTomography(const GridGeometry& geometry, const DriveData& drive,
                                       const BeliefModel& model, const Config& config, bool radio,
                                       const std::atomic<bool>& stop) {
  FusedBelief belief{
      Grid<float>(geometry, kUnknownOccupancy), Grid<float>(geometry), {}, 0.0, {}, {}};
  if (drive.path.empty()) {
    belief.sample_loss.resize(drive.heard.size());
    return belief;
  }
  DriveFeatures described = extractDriveFeatures(drive, config, stop);
  if (stop) {
    belief.sample_loss.resize(drive.heard.size());
    return belief;
  }
  belief.frame = described.frame;
  belief.style = model.shares(described.cells.style);
  belief.explained = described.cells.explained;
  clampExplainedVariance(kLeastExplained, kMostExplained, described.cells);
  const Grid<float> free = freeProbability(described.cells, model, belief.style, radio);
  belief.occupied = onMap(geometry, free, described.frame, 0.5F);
  for (float& occupied : belief.occupied.cells) {
    occupied = 1.0F - occupied;
  }
  belief.wall_loss = onMap(geometry, described.walls.loss_db, described.frame, 0.0F);
  belief.sample_loss = sampleLosses(drive, described);
  const Mask path = drivenPath(geometry, drive.path, config.path).cells;
  stampFootprintAndContacts(path, drive.contacts, config.path.footprint_radius_m, belief.occupied);
  labelFreeAndRim(path, config.belief, belief.occupied);
  return belief;
}

}  // namespace sfw
