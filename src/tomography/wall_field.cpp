#include "tomography/wall_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/constants.h"
#include "base/erase_if.h"
#include "base/random.h"
#include "base/random_streams.h"
#include "grid/cells_at_centres.h"
#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "grid/morphology.h"

namespace sfw {
namespace {

/// A robot keeps away from walls. So a wall is unlikely next to the robot's footprint, and becomes
/// as likely as anywhere else over this distance.
constexpr double kWallClearanceScaleM = 0.2;

/// The number with its digits in a base mirrored about the point (van der Corput 1935): any number
/// of such shifts fills [0, 1) evenly.
double vanDerCorput(int number, int base) {
  double value = 0.0;
  double digit = 1.0 / base;
  for (; number > 0; number /= base, digit /= base) {
    value += digit * (number % base);
  }
  return value;
}

/// A member's lattices: each covers the result's grid, shifted by part of a cell.
std::vector<LineLattice> shiftedLattices(int member, const GridGeometry& geometry,
                                         const WallFieldConfig& config) {
  const double resolution = config.line_resolution_m;
  const Position offset(vanDerCorput(member, 2) * resolution, vanDerCorput(member, 3) * resolution);
  std::vector<LineLattice> lattices;
  for (int i = 0; i < config.wall_directions / 2; ++i) {
    LineLattice lattice{geometry, i * kPi / config.wall_directions};
    Box box;
    for (const auto corner : {Box::BottomLeft, Box::BottomRight, Box::TopLeft, Box::TopRight}) {
      box.extend(lattice.toLattice(geometry.box().corner(corner)));
    }
    const Position size = box.sizes();
    lattice.geometry =
        GridGeometry(resolution, box.min() - offset,
                     static_cast<std::int64_t>(std::ceil(size.x() / resolution)) + 1,
                     static_cast<std::int64_t>(std::ceil(size.y() / resolution)) + 1);
    lattices.push_back(lattice);
  }
  return lattices;
}

/// The bins that a member uses; all if it is the only member.
std::vector<AccessPointBins> subsample(int member,
                                       const std::vector<AccessPointBins>& access_points,
                                       const WallFieldConfig& config) {
  std::vector<AccessPointBins> part = access_points;
  if (config.ensemble_size < 2) {
    return part;
  }
  for (std::size_t i = 0; i < part.size(); ++i) {
    Random random(member, streamOf(Purpose::kLeftOutBins, i), 0);
    eraseIf(part[i].bins,
            [&](const RadioBin&) { return random.uniform() <= config.holdout_fraction; });
  }
  return part;
}

/// Cells of a lattice whose centres lie within the robot's radius of the path.
Mask coveredOn(const LineLattice& lattice, const Grid<double>& distance, double radius_m) {
  Mask driven(lattice.geometry);
  const GridGeometry& fine = distance.geometry;
  const auto enter = [&](auto&& cellAtCentre) {
    forEachCell(lattice.geometry, [&](Cell c) {
      const Cell at = cellAtCentre(c);
      driven[c] = fine.contains(at) && distance[at] * fine.resolution() <= radius_m ? 1 : 0;
    });
  };
  if (lattice.yaw_rad == 0.0) {
    const CellsAtCentres cells(lattice.geometry, fine);
    enter([&](Cell c) { return cells[c]; });
  } else {
    enter([&](Cell c) { return fine.cellAt(lattice.toBuilding(lattice.geometry.centre(c))); });
  }
  return driven;
}

/// Adds a member's losses at the cells of the result.
void addTo(Grid<float>& sum, const LineField& member, float share) {
  for (const LatticeLoss& loss : member) {
    const LineLattice& lattice = loss.lattice;
    const auto enter = [&](auto&& cellAtCentre) {
      forEachCell(sum.geometry, [&](Cell c) {
        const Cell at = cellAtCentre(c);
        if (lattice.geometry.contains(at)) {  // a kept member may be smaller
          sum[c] += share * (loss.walls_along_y[at] + loss.walls_along_x[at]);
        }
      });
    };
    if (lattice.yaw_rad == 0.0) {
      const CellsAtCentres cells(sum.geometry, lattice.geometry);
      enter([&](Cell c) { return cells[c]; });
    } else {
      enter([&](Cell c) {
        return lattice.geometry.cellAt(lattice.toLattice(sum.geometry.centre(c)));
      });
    }
  }
}

/// Reduces losses close to the path, where a wall would have stood in the robot's way.
void weakenBesidePath(const Grid<double>& distance, double radius_m, Grid<float>& loss_db) {
  for (std::size_t i = 0; i < loss_db.cells.size(); ++i) {
    const double away = std::max(0.0, distance.cells[i] * loss_db.geometry.resolution() - radius_m);
    const double likely = 1.0 - std::exp(-away / kWallClearanceScaleM);
    loss_db.cells[i] *= static_cast<float>(likely * likely);
  }
}

/// The members of a wall field and their mean.
class Ensemble {
 public:
  /// All arguments are those of estimateWalls, and must outlive this.
  Ensemble(const GridGeometry& geometry, const std::vector<AccessPointBins>& access_points,
           const Mask& path, double robot_radius_m, const WallFieldConfig& config,
           const std::atomic<bool>& stop)
      : geometry_(geometry),
        access_points_(access_points),
        distance_(distanceTransform(path)),
        robot_radius_m_(robot_radius_m),
        config_(config),
        stop_(stop) {}

  LineField solved(int member) const {
    const std::vector<LineLattice> lattices = shiftedLattices(member, geometry_, config_);
    std::vector<Mask> driven;
    driven.reserve(lattices.size());
    for (const LineLattice& lattice : lattices) {
      driven.push_back(coveredOn(lattice, distance_, robot_radius_m_));
    }
    return solveLineField(lattices, subsample(member, access_points_, config_), driven,
                          config_.line, stop_);
  }

  WallField combined(std::vector<LineField> members) const {
    WallField result{std::move(members), Grid<float>(geometry_), {}};
    for (const LineField& member : result.members) {
      addTo(result.loss_db, member, 1.0F / static_cast<float>(config_.ensemble_size));
    }
    weakenBesidePath(distance_, robot_radius_m_, result.loss_db);
    for (const AccessPointBins& one : access_points_) {
      result.ray_loss_db.emplace_back(one.bins.size(), 0.0);
      for (std::size_t i = 0; i < one.bins.size() && !stop_; ++i) {
        result.ray_loss_db.back()[i] = lossBetween(result, one.position, one.bins[i].position);
      }
    }
    return result;
  }

 private:
  const GridGeometry& geometry_;
  const std::vector<AccessPointBins>& access_points_;
  Grid<double> distance_;  // to the path, in cells
  double robot_radius_m_;
  const WallFieldConfig& config_;
  const std::atomic<bool>& stop_;
};

}  // namespace

double lossBetween(const WallField& field, const Position& from, const Position& to) {
  double sum = 0.0;
  for (const LineField& member : field.members) {
    sum += lossBetween(member, from, to);
  }
  return sum / static_cast<double>(std::max<std::size_t>(field.members.size(), 1));
}

WallField estimateWalls(const GridGeometry& geometry,
                        const std::vector<AccessPointBins>& access_points, const Mask& path,
                        double robot_radius_m, const WallFieldConfig& config,
                        const std::atomic<bool>& stop) {
  const Ensemble ensemble(geometry, access_points, path, robot_radius_m, config, stop);
  std::vector<LineField> members;
  for (int member = 0; member < config.ensemble_size && !stop; ++member) {
    members.push_back(ensemble.solved(member));
  }
  return ensemble.combined(std::move(members));
}

WallField refreshWalls(const WallData& data, double robot_radius_m, const WallFieldConfig& config,
                       const std::atomic<bool>& stop, KeptMembers& kept) {
  const Ensemble ensemble(data.path.geometry, data.access_points, data.path, robot_radius_m, config,
                          stop);
  return ensemble.combined(kept.refresh(
      data, config.ensemble_size, [&](int member) { return ensemble.solved(member); }, stop));
}

}  // namespace sfw
