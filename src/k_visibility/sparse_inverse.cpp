#include "k_visibility/sparse_inverse.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/log_odds.h"
#include "grid/for_each_cell.h"
#include "grid/mask.h"
#include "grid/ray.h"
#include "grid/robot_evidence.h"

namespace sfw {
namespace {

constexpr std::int64_t kOutside = -1;   // index of a cell outside the grid
constexpr double kRayCertainty = 0.95;  // limit for any number of correlated rays

/// Wall counts to one access point in the cells that the path crosses.
class PathCells {
 public:
  explicit PathCells(const GridGeometry& geometry) : sums_(geometry), crossed_(geometry) {}

  /// Inserts a path. Each cell gets the count of the nearer of its two adjacent poses.
  void enter(const CountedPath& path, double max_gap_m) {
    for (std::size_t i = 0; i < path.poses.size(); ++i) {
      const CountedPose& from = path.poses[i];
      const CountedPose& to = path.poses[i + 1 < path.poses.size() ? i + 1 : i];
      const Position middle = (from.antenna_in_map + to.antenna_in_map) / 2.0;
      if (from.is_last || (to.antenna_in_map - from.antenna_in_map).norm() > max_gap_m) {
        enter(from.antenna_in_map, from.antenna_in_map, from.walls);
        continue;
      }
      enter(from.antenna_in_map, middle, from.walls);
      enter(middle, to.antenna_in_map, to.walls);
    }
    std::sort(cells_.begin(), cells_.end(),
              [this](Cell a, Cell b) { return sums_.geometry.index(a) < sums_.geometry.index(b); });
    for (const Cell c : cells_) {
      crossed_[c] = 1;
    }
  }

  const std::vector<Cell>& cells() const { return cells_; }
  bool crossed(std::int64_t index) const {
    return crossed_.cells[static_cast<std::size_t>(index)] != 0;
  }

  /// Mean count of all passes through a crossed cell, rounded.
  int walls(std::int64_t index) const {
    const Sum& sum = sums_.cells[static_cast<std::size_t>(index)];
    return static_cast<int>((2 * sum.walls + sum.poses) / (2 * sum.poses));
  }

 private:
  struct Sum {
    std::int32_t walls = 0;
    std::int32_t poses = 0;
  };

  void enter(const Position& from, const Position& to, int walls) {
    Ray(sums_.geometry, from, to).forEachCell([&](Cell c) {
      if (!sums_.geometry.contains(c)) {
        return;
      }
      Sum& sum = sums_[c];
      if (sum.poses == 0) {
        cells_.push_back(c);
      }
      sum.walls += walls;
      sum.poses += 1;
    });
  }

  Grid<Sum> sums_;
  Mask crossed_;  // the cells with poses: far smaller than the sums, so rays walk it faster
  std::vector<Cell> cells_;
};

/// Keeps what wallMass returns. The rays of a path have few different segments.
class WallMasses {
 public:
  explicit WallMasses(double wall_cells) : wall_cells_(wall_cells) {}

  const std::vector<double>& of(std::size_t cells, int walls) {
    const auto [mass, is_new] = masses_.try_emplace({cells, walls});
    if (is_new) {
      mass->second = wallMass(cells, walls, wall_cells_);
    }
    return mass->second;
  }

 private:
  double wall_cells_;
  std::map<std::pair<std::size_t, int>, std::vector<double>> masses_;
};

/// Adds the evidence of one segment to its cells.
///
/// Its variance grows with the square of its length. The midpoint of a long segment is a poor
/// estimate of a wall's position. Two equal counts far apart hardly exclude a wall between them.
void addSegment(const RaySegment& segment, const std::vector<std::int64_t>& ray,
                const SparseInverseConfig& config, WallMasses& masses,
                Grid<CellEvidence>& evidence) {
  const double resolution = evidence.geometry.resolution();
  const std::size_t cells = segment.end - segment.begin;
  const double length = static_cast<double>(cells) * resolution;
  if (segment.walls < 0) {
    return;  // one of the two counts is wrong, and it is unknown which
  }
  const double least_room = 2.0 * config.footprint_radius_m + config.wall_thickness_m;
  if (segment.walls > 0 && length < least_room) {
    return;  // no wall fits between two footprints this close
  }
  const double weight = 1.0 / (length * length);
  if (segment.walls == 0) {
    for (std::size_t i = segment.begin; i < segment.end; ++i) {
      if (ray[i] != kOutside) {
        evidence.cells[static_cast<std::size_t>(ray[i])].weight += weight;
      }
    }
    return;
  }
  const std::vector<double>& mass = masses.of(cells, segment.walls);
  for (std::size_t i = 0; i < cells; ++i) {
    const std::int64_t index = ray[segment.begin + i];
    if (index != kOutside) {
      CellEvidence& cell = evidence.cells[static_cast<std::size_t>(index)];
      // A wall somewhere on the segment is never evidence that one of its cells is free (Rule 3).
      cell.weighted_mass += weight * std::max(mass[i], config.wall_prior);
      cell.weight += weight;
    }
  }
}

/// Adds the evidence of all rays to one access point.
void addRays(const CountedPath& counted, const SparseInverseConfig& config,
             const std::atomic<bool>& stop, WallMasses& masses, Grid<CellEvidence>& evidence) {
  const GridGeometry& geometry = evidence.geometry;
  PathCells path(geometry);
  path.enter(counted, config.max_gap_m);
  std::vector<std::int64_t> ray;  // indices of cells, or kOutside
  std::vector<CountedCell> known;
  for (const Cell end : path.cells()) {
    if (stop) {
      return;
    }
    const Ray to_end(geometry, counted.access_point, geometry.centre(end));
    ray.resize(to_end.mostCells());
    known.assign(1, CountedCell{0, 0});
    std::size_t cells = 0;
    to_end.forEachCell([&](Cell cell) {
      const std::int64_t index =
          geometry.contains(cell) ? static_cast<std::int64_t>(geometry.index(cell)) : kOutside;
      ray[cells] = index;
      if (cells > 0 && index != kOutside && path.crossed(index)) {
        known.push_back({cells, path.walls(index)});
      }
      ++cells;
    });
    for (const RaySegment& segment : segmentRay(known)) {
      addSegment(segment, ray, config, masses, evidence);
    }
  }
}

/// Occupancy from fused mass, relative to the prior of an unseen cell.
float occupancy(const CellEvidence& evidence, double wall_prior) {
  const double mass = std::clamp(evidence.mass(), 0.0, 1.0);  // a sum may pass 1 by its rounding
  const double probability = logistic(logit(mass) - logit(wall_prior));
  return static_cast<float>(std::clamp(probability, 1.0 - kRayCertainty, kRayCertainty));
}

/// Rule 1: frees the cells of the robot's footprint, at least the cell of its antenna.
void freeFootprints(const std::vector<Position>& path, const SparseInverseConfig& config,
                    Grid<float>& occupied) {
  const GridGeometry& geometry = occupied.geometry;
  const double radius = config.footprint_radius_m;
  const Position reach(radius, radius);
  for (const Position& pose : path) {
    const Cell own = geometry.cellAt(pose);
    forEachCell(geometry.cellAt(pose - reach), geometry.cellAt(pose + reach), [&](Cell c) {
      const bool covered = c == own || (geometry.centre(c) - pose).norm() <= radius;
      if (covered && geometry.contains(c)) {
        occupied[c] = kFootprintOccupancy;
      }
    });
  }
}

/// The path with poses added so that footprints overlap, except across gaps.
std::vector<Position> densified(const std::vector<Position>& path, double spacing_m,
                                double max_gap_m) {
  std::vector<Position> dense;
  for (std::size_t i = 0; i < path.size(); ++i) {
    dense.push_back(path[i]);
    if (i + 1 == path.size()) {
      break;
    }
    const Position way = path[i + 1] - path[i];
    if (way.norm() > max_gap_m) {
      continue;
    }
    const int parts = static_cast<int>(std::ceil(way.norm() / spacing_m));
    for (int part = 1; part < parts; ++part) {
      dense.emplace_back(path[i] + way * (static_cast<double>(part) / parts));
    }
  }
  return dense;
}

}  // namespace

std::vector<RaySegment> segmentRay(const std::vector<CountedCell>& known) {
  std::vector<RaySegment> segments;
  for (std::size_t i = 1; i < known.size(); ++i) {
    const RaySegment segment{known[i - 1].index + 1, known[i].index,
                             known[i].walls - known[i - 1].walls};
    if (segment.begin < segment.end) {
      segments.push_back(segment);
    }
  }
  return segments;
}

std::vector<double> wallMass(std::size_t cells, int walls, double wall_cells) {
  std::vector<double> mass(cells, 0.0);
  if (walls <= 0) {
    return mass;
  }
  const double spacing = static_cast<double>(cells) / walls;
  const double sd = spacing / 4.0;
  double sum = 0.0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double centre = static_cast<double>(cell) + 0.5;
    for (int wall = 0; wall < walls; ++wall) {
      const double z = (centre - (wall + 0.5) * spacing) / sd;
      mass[cell] += std::exp(-z * z / 2.0);
    }
    sum += mass[cell];
  }
  for (double& m : mass) {
    m = std::min(1.0, m * walls * wall_cells / sum);
  }
  return mass;
}

SparseInverseConfig sparseInverseConfig(const Config& config) {
  return {config.path.footprint_radius_m, config.path.max_gap_m,
          config.k_visibility.wall_thickness_m, config.k_visibility.wall_prior};
}

Grid<float> inferOccupancy(const GridGeometry& geometry, const std::vector<CountedPath>& counted,
                           const std::vector<Position>& path, const std::vector<Contact>& contacts,
                           const SparseInverseConfig& config, const std::atomic<bool>& stop) {
  Grid<CellEvidence> evidence(geometry);
  WallMasses masses(config.wall_thickness_m / geometry.resolution());
  for (const CountedPath& one : counted) {
    addRays(one, config, stop, masses, evidence);
  }
  Grid<float> occupied(geometry, kUnknownOccupancy);
  for (std::size_t i = 0; i < evidence.cells.size(); ++i) {
    if (evidence.cells[i].weight > 0.0) {
      occupied.cells[i] = occupancy(evidence.cells[i], config.wall_prior);
    }
  }
  freeFootprints(densified(path, geometry.resolution(), config.max_gap_m), config, occupied);
  stampContacts(contacts, occupied);
  return occupied;
}

}  // namespace sfw
