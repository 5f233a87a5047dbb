#include "mapping/fused_belief.h"

#include <cmath>

#include "belief/free_and_rim.h"
#include "belief/free_probability.h"
#include "grid/morphology.h"
#include "grid/robot_evidence.h"
#include "walls/network_inputs.h"
#include "walls/network_walls.h"

namespace sfw {
namespace {

/// Interpolates linearly between the centres of the four nearest cells; `outside` stands for cells
/// beyond the grid.
float interpolated(const Grid<float>& values, const Position& position, float outside) {
  const GridGeometry& geometry = values.geometry;
  const Position at = geometry.toCells(position) - Position(0.5, 0.5);
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

/// Resamples a grid of the building frame on the grid of the map.
Grid<float> onMap(const GridGeometry& geometry, const Grid<float>& values,
                  const BuildingFrame& frame, float outside) {
  Grid<float> result(geometry, outside);
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const Position position = frame.toBuilding(geometry.centre(geometry.cell(i)));
    result.cells[i] = interpolated(values, position, outside);
  }
  return result;
}

/// The belief model gives probabilities of free space, and a map holds those of occupied space.
/// Only this function converts between them.
Grid<float> occupancyOnMap(const GridGeometry& geometry, const Grid<float>& free,
                           const BuildingFrame& frame) {
  Grid<float> occupied = onMap(geometry, free, frame, kUnknownOccupancy);
  for (float& p : occupied.cells) {
    p = 1.0F - p;
  }
  return occupied;
}

/// The cells of walls on the grid of a map. The robot's footprint stays free of them.
/// @param building   grid of the walls' cells, building frame
/// @param footprint  of the robot, on the map
Mask wallsOnMap(const std::vector<StripWall>& found, const GridGeometry& building,
                const BuildingFrame& frame, const Mask& footprint) {
  Mask in_building(building);
  for (const StripWall& wall : found) {
    for (const Cell c : wall.cells) {
      in_building[c] = 1;
    }
  }
  Mask walls(footprint.geometry);
  for (std::size_t i = 0; i < walls.cells.size(); ++i) {
    const Position centre = walls.geometry.centre(walls.geometry.cell(i));
    const Cell c = building.cellAt(frame.toBuilding(centre));
    walls.cells[i] = footprint.cells[i] == 0 && building.contains(c) ? in_building[c] : 0;
  }
  return walls;
}

std::vector<std::vector<double>> sampleLosses(const DriveData& drive,
                                              const DriveFeatures& features) {
  std::vector<std::vector<double>> losses_db;
  for (std::size_t i = 0; i < drive.access_points.size(); ++i) {
    losses_db.emplace_back();
    for (const Sample& sample : drive.access_points[i].samples) {
      losses_db.back().push_back(lossBetween(features.walls, features.access_points[i].position,
                                             features.frame.toBuilding(sample.antenna_in_map)));
    }
  }
  return losses_db;
}

}  // namespace

FusedBelief inferOccupancyByTomography(const GridGeometry& geometry, const DriveData& drive,
                                       const BeliefModel& model,
                                       const std::optional<WallNetwork>& network,
                                       const Config& config, UseRadio use_radio,
                                       const std::atomic<bool>& stop) {
  FusedBelief belief{
      Grid<float>(geometry, kUnknownOccupancy), Grid<float>(geometry), {}, 0.0, {}, {}};
  belief.sample_loss_db.resize(drive.access_points.size());
  if (drive.path.empty()) {
    return belief;
  }
  Config features_config = config;
  if (network) {
    features_config.map.resolution_m = kNetworkCellM;
  }
  const DriveFeatures features =
      extractDriveFeatures(drive, features_config, stop, kTrustedVariance);
  if (stop) {
    return belief;
  }
  belief.frame = features.frame;
  belief.style = model.shares(features.cells.style);
  belief.explained_variance = features.cells.explained_variance;
  const Grid<float> free = freeProbability(features.cells, model, belief.style, use_radio);
  belief.occupied = occupancyOnMap(geometry, free, features.frame);
  belief.wall_loss = onMap(geometry, features.walls.loss_db, features.frame, 0.0F);
  belief.sample_loss_db = sampleLosses(drive, features);
  const Mask path = cellsCrossed(geometry, drive.path, config.path.max_gap_m);
  stampFootprintAndContacts(path, drive.contacts, config.path.footprint_radius_m, belief.occupied);
  Mask walls(geometry);
  if (network) {
    const Mask footprint = dilated(path, config.path.footprint_radius_m / geometry.resolution());
    walls = wallsOnMap(findWallsByNetwork(features, model, belief.style, use_radio, free,
                                          1.0 - config.belief.free_threshold, *network),
                       features.cells.geometry, features.frame, footprint);
  }
  labelFreeAndRim(path, walls, config.belief, belief.occupied);
  return belief;
}

}  // namespace sfw
