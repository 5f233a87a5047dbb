#include "mapping/fused_belief.h"

#include <utility>

#include "belief/free_and_rim.h"
#include "belief/free_probability.h"
#include "grid/morphology.h"
#include "grid/robot_evidence.h"
#include "mapping/resampling.h"
#include "mapping/walls_on_map.h"
#include "walls/network_inputs.h"
#include "walls/network_walls.h"
#include "walls/wall_segments.h"

namespace sfw {
namespace {

/// The belief model gives probabilities of free space, and a map holds those of occupied space.
/// Only this function converts between them.
Grid<float> occupancyOf(Grid<float> free) {
  for (float& p : free.cells) {
    p = 1.0F - p;
  }
  return free;
}

/// The network's probability that each cell is occupied. Cells that a lidar would hardly see have
/// none, because no drive like those of its training tells what stands there.
/// @param unseen  probability that a lidar would not see a cell, on the grid of the map
Grid<float> withoutUnseen(Grid<float> probability, const Grid<float>& unseen) {
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

/// Enters what the network finds, and the losses of walls.
void enterFindings(const NetworkFindings& found, const Grid<float>& loss_db,
                   const GridGeometry& geometry, FusedBelief& belief) {
  std::vector<Grid<float>> grids = onMap(geometry,
                                         {{found.free, kUnknownOccupancy},
                                          {found.occupied, kUnknownOccupancy},
                                          {found.unseen, 1.0F},
                                          {loss_db, 0.0F}},
                                         belief.frame);
  belief.occupied = occupancyOf(std::move(grids[0]));
  belief.probability = withoutUnseen(std::move(grids[1]), grids[2]);
  belief.wall_loss = std::move(grids[3]);
  belief.walls = segmentsInMap(found.walls, loss_db.geometry, belief.frame);
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
    enterFindings(found, features.walls.loss_db, geometry, belief);
    walls = wallsOnMap(found.walls, features.cells.geometry, belief.frame, open);
  } else {
    std::vector<Grid<float>> grids =
        onMap(geometry, {{free, kUnknownOccupancy}, {features.walls.loss_db, 0.0F}}, belief.frame);
    belief.occupied = occupancyOf(std::move(grids[0]));
    belief.probability = belief.occupied;
    belief.wall_loss = std::move(grids[1]);
  }
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
