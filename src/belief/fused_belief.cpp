#include "belief/fused_belief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/map_too_large.h"
#include "grid/axis_rasters.h"
#include "grid/distance_transform.h"
#include "grid/morphology.h"
#include "grid/ray.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr float kUnknown = 0.5F;
constexpr float kFootprint = 0.02F;  // the robot stood there
constexpr float kContact = 0.95F;    // the robot ran into it

/// Access points farther than this from the way shape no walls near it [m].
constexpr double kFarthestAccessPoint = 30.0;

/// Shares of the signals that walls explain, as far as the belief reckons with them: a little above
/// the median of the training drives (.5), and what one of ten or twenty of them passes. Signals at
/// wrong places explain too little and would make it doubt all it knows from the path; few readings
/// of many walls explain too much.
constexpr double kLeastExplained = 0.55;
constexpr double kMostExplained = 0.7;

/// Walls are straight: cells of a line along an axis of the building say something of each other,
/// so far [m].
constexpr double kStraight = 0.6;

/// Share of that mean in what is believed of a cell. Logistic regression of the states of cells on
/// their own log odds and on the mean weighs them .33 and .69 (240 training drives of other seeds
/// than the belief model's).
constexpr float kStraightShare = 0.7F;

/// Registration of path and map blurs what is believed by so much to each side [m].
constexpr double kBlur = 0.1;

GridGeometry buildingGeometry(const std::vector<Position>& driven,
                              const std::vector<HeardAccessPoint>& heard,
                              const Config::Map& config) {
  Box way;
  for (const Position& position : driven) {
    way.extend(position);
  }
  constexpr double kAround = 0.5;  // [m]
  const auto grown = [](const Box& box, double by) {
    return Box(box.min() - Position(by, by), box.max() + Position(by, by));
  };
  Box box = grown(way, kFarthestJudged + kAround);
  for (const HeardAccessPoint& one : heard) {
    if (way.exteriorDistance(one.position) < kFarthestAccessPoint) {
      box.extend(grown(Box(one.position), kAround));
    }
  }
  try {
    return GridGeometry::covering(box, config.resolution, config.resolution, 4 * config.max_cells);
  } catch (const std::invalid_argument&) {
    throw InputError(tooLargeText(way, config));
  }
}

WallFieldConfig wallFieldConfig(const Config::Tomography& config) {
  WallFieldConfig walls;
  walls.line.saturation_db =
      config.saturation > 0.0 ? config.saturation : std::numeric_limits<double>::infinity();
  walls.line.sparsity = config.sparsity;
  walls.line.straightness = config.straightness;
  walls.line.shadowing.unexplained_db2 = config.unexplained * config.unexplained;
  walls.directions = static_cast<int>(config.directions);
  walls.members = static_cast<int>(config.members);
  return walls;
}

DrivenPath drivenPath(const GridGeometry& geometry, std::vector<Position> driven,
                      const Config::Inference& config) {
  DrivenPath path{Mask(geometry), std::move(driven), config.max_gap, config.footprint_radius};
  for (std::size_t i = 0; i < path.driven.size(); ++i) {
    const Position& from = path.driven[i];
    const Position& next = path.driven[std::min(i + 1, path.driven.size() - 1)];
    const Position& to = (next - from).norm() > config.max_gap ? from : next;
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

float logOdds(double probability) {
  constexpr double kLeast = 1e-4;  // no cell is surer, however many features agree
  const double p = std::clamp(probability, kLeast, 1.0 - kLeast);
  return static_cast<float>(std::log(p / (1.0 - p)));
}

/// Draws log odds towards their mean along that axis which speaks less for free space: doubt of a
/// line of cells stays, as of a wall, and that of single cells fades. Only judged cells count.
void straighten(const std::vector<std::size_t>& judged, Grid<float>& log_odds) {
  const std::int64_t reach = std::lround(kStraight / log_odds.geometry.resolution());
  Grid<float> counted(log_odds.geometry);
  for (const std::size_t i : judged) {
    counted.cells[i] = 1.0F;
  }
  const Grid<float> row = rowMean(log_odds, reach);
  const Grid<float> row_share = rowMean(counted, reach);
  const Grid<float> column = columnMean(log_odds, reach);
  const Grid<float> column_share = columnMean(counted, reach);
  for (const std::size_t i : judged) {
    // No share is 0: the cell itself counts.
    const float lower =
        std::min(row.cells[i] / row_share.cells[i], column.cells[i] / column_share.cells[i]);
    log_odds.cells[i] += kStraightShare * (lower - log_odds.cells[i]);
  }
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

/// Only the parts that hang together with the seeds.
Mask reachable(const Mask& free, const Mask& seeds) {
  const Components parts = labelComponents(free);
  std::vector<std::uint8_t> reached(static_cast<std::size_t>(parts.count) + 1, 0);
  for (std::size_t i = 0; i < seeds.cells.size(); ++i) {
    if (seeds.cells[i] != 0) {
      reached[static_cast<std::size_t>(parts.label.cells[i])] = 1;
    }
  }
  reached[0] = 0;
  Mask result(free.geometry);
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    result.cells[i] = reached[static_cast<std::size_t>(parts.label.cells[i])];
  }
  return result;
}

/// Keeps probabilities apart from the thresholds, so that no rounding carries them over [1].
constexpr float kApart = 0.02F;

/// Nearly twice what a step of the grid's logarithms of odds is at most where cells are free [1].
constexpr float kStep = 0.015F;

/// Marks as free what the robot covered, and as occupied what it touched.
void enterFelt(const MappedDrive& drive, const Mask& path, const Config& config,
               Grid<float>& occupied) {
  const GridGeometry& geometry = occupied.geometry;
  const Grid<double> distance = distanceTransform(path);
  const double radius = config.inference.footprint_radius / geometry.resolution();
  for (std::size_t i = 0; i < occupied.cells.size(); ++i) {
    if (distance.cells[i] <= radius) {
      occupied.cells[i] = std::min(occupied.cells[i], kFootprint);
    }
  }
  for (const Contact& contact : drive.contacts) {
    const Cell c = geometry.cellAt(contact.point_in_map);
    if (geometry.contains(c)) {
      occupied[c] = kContact;
    }
  }
}

/// Adds to a free area the islands in it on which no cell is as likely as that to be occupied.
void freeIslands(const Grid<float>& occupied, float likely, Mask& free) {
  const GridGeometry& geometry = free.geometry;
  const Components islands = labelComponents(complement(free));
  std::vector<std::uint8_t> freed(static_cast<std::size_t>(islands.count) + 1, 1);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    const Cell c = geometry.cell(i);
    const bool at_edge =
        c.x == 0 || c.y == 0 || c.x + 1 == geometry.width() || c.y + 1 == geometry.height();
    if (at_edge || occupied.cells[i] >= likely) {
      freed[static_cast<std::size_t>(islands.label.cells[i])] = 0;
    }
  }
  freed[0] = 1;  // free already
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    free.cells[i] = freed[static_cast<std::size_t>(islands.label.cells[i])];
  }
}

/// Lets only cells that hang together with the path pass as free and only their rim and contacts
/// as occupied: beyond the rim nobody knows.
void settle(const Mask& path, const Config::Belief& config, Grid<float>& occupied) {
  const auto free_below = static_cast<float>(config.free_threshold);
  const auto occupied_above = static_cast<float>(config.occupied_threshold);
  Mask free(occupied.geometry);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    free.cells[i] = occupied.cells[i] < free_below ? 1 : 0;
  }
  free = reachable(free, path);
  constexpr float kDoubt = 1.4F;  // times the threshold: hardly more than what is free around
  freeIslands(occupied, std::min(kDoubt * free_below, kUnknown), free);
  constexpr double kNeighbour = 1.5;  // cells: over edges and corners
  const Mask rim = dilated(free, kNeighbour);
  const float least = std::min(free_below + kApart, 0.5F * (free_below + occupied_above));
  const float most = std::max(occupied_above - kApart, least);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    float& p = occupied.cells[i];
    if (free.cells[i] != 0) {
      p = std::min(p, free_below - std::min(kStep, 0.5F * free_below));
      continue;
    }
    if (p == kContact || p == kUnknown) {
      continue;
    }
    p = rim.cells[i] != 0 ? std::max(p, std::min(occupied_above + kApart, 1.0F))
                          : std::clamp(p, least, most);
  }
}

std::vector<std::vector<double>> sampleLosses(const MappedDrive& drive,
                                              const DescribedDrive& described) {
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

DescribedDrive describeDrive(const MappedDrive& drive, const Config& config,
                             const std::atomic<bool>& stop) {
  const BuildingFrame frame = findBuildingFrame(drive.path, config.inference.max_gap);
  std::vector<Position> driven;
  driven.reserve(drive.path.size());
  for (const Position& position : drive.path) {
    driven.push_back(frame.toBuilding(position));
  }
  std::vector<HeardAccessPoint> heard;
  for (const HeardSamples& one : drive.heard) {
    heard.push_back(
        binned(one.samples, one.access_point_in_map, one.height_m, frame, config.tomography.bin));
  }
  const GridGeometry geometry = buildingGeometry(driven, heard, config.map);
  const DrivenPath path = drivenPath(geometry, std::move(driven), config.inference);
  WallField walls = estimateWalls(geometry, heard, path.cells, path.robot_radius_m,
                                  wallFieldConfig(config.tomography), stop);
  CellFeatures cells = describeCells(path, heard, walls, stop);
  return {frame, std::move(heard), std::move(walls), std::move(cells)};
}

Grid<float> freeProbability(const CellFeatures& judged, const BeliefModel& model,
                            const StyleShares& style, bool radio) {
  Grid<float> free(judged.geometry);
  for (std::size_t i = 0; i < judged.cells.size(); ++i) {
    free.cells[judged.cells[i]] = logOdds(model.free(judged.values[i], style, radio));
  }
  straighten(judged.cells, free);
  for (const std::size_t i : judged.cells) {
    free.cells[i] = 1.0F / (1.0F + std::exp(-free.cells[i]));
  }
  free = boxMean(free, std::lround(kBlur / free.geometry.resolution()));
  Grid<float> probability(judged.geometry, kUnknown);
  for (const std::size_t i : judged.cells) {
    probability.cells[i] = free.cells[i];
  }
  return probability;
}

FusedBelief fuse(const GridGeometry& geometry, const MappedDrive& drive, const BeliefModel& model,
                 const Config& config, bool radio, const std::atomic<bool>& stop) {
  FusedBelief belief{Grid<float>(geometry, kUnknown), Grid<float>(geometry), {}, 0.0, {}, {}};
  if (drive.path.empty()) {
    belief.sample_loss.resize(drive.heard.size());
    return belief;
  }
  DescribedDrive described = describeDrive(drive, config, stop);
  if (stop) {
    belief.sample_loss.resize(drive.heard.size());
    return belief;
  }
  belief.frame = described.frame;
  belief.style = model.shares(described.cells.style);
  belief.explained = described.cells.explained;
  cutExplained(kLeastExplained, kMostExplained, described.cells);
  const Grid<float> free = freeProbability(described.cells, model, belief.style, radio);
  belief.occupied = onMap(geometry, free, described.frame, 0.5F);
  for (float& occupied : belief.occupied.cells) {
    occupied = 1.0F - occupied;
  }
  belief.wall_loss = onMap(geometry, described.walls.strength, described.frame, 0.0F);
  belief.sample_loss = sampleLosses(drive, described);
  const Mask path = drivenPath(geometry, drive.path, config.inference).cells;
  enterFelt(drive, path, config, belief.occupied);
  settle(path, config.belief, belief.occupied);
  return belief;
}

}  // namespace sfw
