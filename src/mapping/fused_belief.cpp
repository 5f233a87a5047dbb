#include "mapping/fused_belief.h"

#include <cmath>

#include "base/function_versions.h"
#include "belief/free_and_rim.h"
#include "belief/free_probability.h"
#include "grid/for_each_cell.h"
#include "grid/morphology.h"
#include "grid/robot_evidence.h"
#include "mapping/walls_on_map.h"
#include "walls/network_inputs.h"
#include "walls/network_walls.h"
#include "walls/wall_segments.h"

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
SFW_FUNCTION_VERSIONS
Grid<float> onMap(const GridGeometry& geometry, const Grid<float>& values,
                  const BuildingFrame& frame, float outside) {
  Grid<float> result(geometry, outside);
  const Eigen::Matrix2d to_building = frame.toBuildingAxes();
  forEachCell(geometry, [&](Cell c) {
    result[c] = interpolated(values, to_building * geometry.centre(c), outside);
  });
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

/// The network's probability that each cell is occupied. Cells that a lidar would hardly see have
/// none, because no drive like those of its training tells what stands there.
Grid<float> probabilityByNetwork(const GridGeometry& geometry, const NetworkFindings& found,
                                 const BuildingFrame& frame) {
  Grid<float> probability = onMap(geometry, found.occupied, frame, kUnknownOccupancy);
  const Grid<float> unseen = onMap(geometry, found.unseen, frame, 1.0F);
  constexpr float kHardlySeen = 0.5F;
  for (std::size_t i = 0; i < probability.cells.size(); ++i) {
    if (unseen.cells[i] > kHardlySeen) {
      probability.cells[i] = kUnknownOccupancy;
    }
  }
  return probability;
}

/// The straight pieces of walls in the frame of the map.
/// @param building  grid of the walls' cells, building frame
std::vector<WallSegment> segmentsInMap(const std::vector<StripWall>& found,
                                       const GridGeometry& building, const BuildingFrame& frame) {
  std::vector<WallSegment> segments;
  for (const StripWall& wall : found) {
    for (const WallSegment& piece : straightPieces(wall, building)) {
      segments.push_back(
          {frame.toMap(piece.from), frame.toMap(piece.to), piece.confidence, piece.is_outer});
    }
  }
  return segments;
}

/// The loss of each sample: that on the ray to its bin, or to itself where the bin was dropped.
std::vector<std::vector<double>> sampleLosses(const DriveData& drive, const DriveFeatures& features,
                                              double bin_size_m) {
  std::vector<std::vector<double>> losses_db;
  for (std::size_t i = 0; i < drive.access_points.size(); ++i) {
    const std::vector<Sample>& samples = drive.access_points[i].samples;
    const AccessPointBins& binned = features.access_points[i];
    const std::vector<std::size_t> bin_of =
        binsOfSamples(samples, binned, features.frame, bin_size_m);
    losses_db.emplace_back();
    losses_db.back().reserve(samples.size());
    for (std::size_t j = 0; j < samples.size(); ++j) {
      losses_db.back().push_back(
          bin_of[j] < binned.bins.size()
              ? features.walls.ray_loss_db[i][bin_of[j]]
              : lossBetween(features.walls, binned.position,
                            features.frame.toBuilding(samples[j].antenna_in_map)));
    }
  }
  return losses_db;
}

FusedBelief withoutEvidence(const GridGeometry& geometry, const DriveData& drive) {
  FusedBelief belief{Grid<float>(geometry, kUnknownOccupancy),
                     Grid<float>(geometry, kUnknownOccupancy),
                     Grid<float>(geometry),
                     {},
                     0.0,
                     {},
                     {},
                     {}};
  belief.sample_loss_db.resize(drive.access_points.size());
  return belief;
}

Config onCellsOfNetwork(Config config) {
  config.map.resolution_m = kNetworkCellM;
  return config;
}

/// Enters what the network finds.
/// @param open  cells on the map that no wall may take
/// @return the cells of walls on the map
Mask enterFindings(const NetworkFindings& found, const GridGeometry& building, const Mask& open,
                   FusedBelief& belief) {
  belief.walls = segmentsInMap(found.walls, building, belief.frame);
  belief.occupied = occupancyOnMap(open.geometry, found.free, belief.frame);
  belief.probability = probabilityByNetwork(open.geometry, found, belief.frame);
  return wallsOnMap(found.walls, building, belief.frame, open);
}

}  // namespace

FusedBelief inferOccupancyByTomography(const GridGeometry& geometry, const DriveData& drive,
                                       const BeliefModel& model,
                                       const std::optional<WallNetwork>& network,
                                       const Config& config, UseRadio use_radio,
                                       const std::atomic<bool>& stop, KeptFeatures* kept) {
  FusedBelief belief = withoutEvidence(geometry, drive);
  if (drive.path.empty()) {
    return belief;
  }
  const DriveFeatures features = extractDriveFeatures(
      drive, network ? onCellsOfNetwork(config) : config, stop, kTrustedVariance, kept);
  if (stop) {
    return belief;
  }
  belief.frame = features.frame;
  belief.style = model.shares(features.cells.style);
  belief.explained_variance = features.cells.explained_variance;
  const Grid<float> free = freeProbability(features.cells, model, belief.style, use_radio);
  const double radius_m = config.path.footprint_radius_m;
  const Mask path = cellsCrossed(geometry, drive.path, config.path.max_gap_m);
  Mask walls(geometry);
  if (network) {
    const NetworkFindings found =
        findWallsByNetwork(features, model, belief.style, use_radio, free,
                           1.0 - config.belief.free_threshold, *network, stop);
    if (stop) {
      return belief;
    }
    // One more cell than the footprint stays open, so that a planner that rounds to cells can drive
    // the robot's way again.
    const Mask open = dilated(path, radius_m / geometry.resolution() + 1.0);
    walls = enterFindings(found, features.cells.geometry, open, belief);
  } else {
    belief.occupied = occupancyOnMap(geometry, free, features.frame);
    belief.probability = belief.occupied;
  }
  belief.wall_loss = onMap(geometry, features.walls.loss_db, features.frame, 0.0F);
  belief.sample_loss_db = sampleLosses(drive, features, config.tomography.bin_size_m);
  if (stop) {
    return belief;
  }
  for (Grid<float>* occupied : {&belief.occupied, &belief.probability}) {
    stampFootprintAndContacts(path, drive.contacts, radius_m, *occupied);
  }
  labelFreeAndRim(path, walls, config.belief, belief.occupied);
  return belief;
}

}  // namespace sfw
