#include "structure_from_wifi/wall_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "random_streams.h"
#include "structure_from_wifi/morphology.h"
#include "structure_from_wifi/random.h"

namespace sfw {
namespace {

/// A robot keeps away from walls: next to its footprint a wall is unlikely, over this distance it
/// becomes as likely as anywhere [m].
constexpr double kShyness = 0.2;

/// Fraction of the whole numbers' reversed digits in a base (van der Corput 1935): shifts that
/// fill [0, 1) evenly however many there are.
double evenly(int number, int base) {
  double value = 0.0;
  double digit = 1.0 / base;
  for (; number > 0; number /= base, digit /= base) {
    value += digit * (number % base);
  }
  return value;
}

/// A member's lattice: covers the result's, shifted by part of a cell.
GridGeometry shifted(const GridGeometry& geometry, double resolution, int member) {
  const Position offset(evenly(member, 2) * resolution, evenly(member, 3) * resolution);
  const Position size = geometry.box().sizes();
  return {resolution, geometry.origin() - offset,
          static_cast<std::int64_t>(std::ceil(size.x() / resolution)) + 1,
          static_cast<std::int64_t>(std::ceil(size.y() / resolution)) + 1};
}

/// The bins that a member hears; all if it is the only one.
std::vector<HeardAccessPoint> heardBy(int member, const std::vector<HeardAccessPoint>& heard,
                                      const WallFieldConfig& config) {
  std::vector<HeardAccessPoint> part = heard;
  if (config.members < 2) {
    return part;
  }
  for (std::size_t i = 0; i < part.size(); ++i) {
    Random random(member, streamOf(Purpose::kLeftOutBins, i), 0);
    std::vector<RadioBin>& bins = part[i].bins;
    bins.erase(std::remove_if(bins.begin(), bins.end(),
                              [&](const RadioBin&) { return random.uniform() <= config.left_out; }),
               bins.end());
  }
  return part;
}

Mask coarsened(const Grid<double>& distance, const GridGeometry& coarse, double radius) {
  Mask driven(coarse);
  const GridGeometry& fine = distance.geometry;
  Cell c;
  for (c.y = 0; c.y < coarse.height(); ++c.y) {
    for (c.x = 0; c.x < coarse.width(); ++c.x) {
      const Cell at = fine.cellAt(coarse.centre(c));
      driven[c] = fine.contains(at) && distance[at] * fine.resolution() <= radius ? 1 : 0;
    }
  }
  return driven;
}

void addTo(LineField& sum, const LineField& member, float share) {
  const GridGeometry& fine = sum.across_x.geometry;
  const GridGeometry& coarse = member.across_x.geometry;
  Cell c;
  for (c.y = 0; c.y < fine.height(); ++c.y) {
    for (c.x = 0; c.x < fine.width(); ++c.x) {
      const Cell at = coarse.cellAt(fine.centre(c));
      sum.across_x[c] += share * member.across_x[at];
      sum.across_y[c] += share * member.across_y[at];
    }
  }
}

/// Both directions together, less where the robot is unlikely to have come so near to a wall.
Grid<float> strengthOf(const LineField& loss, const Grid<double>& distance, double radius) {
  const GridGeometry& geometry = loss.across_x.geometry;
  Grid<float> strength(geometry);
  for (std::size_t i = 0; i < strength.cells.size(); ++i) {
    const double away = std::max(0.0, distance.cells[i] * geometry.resolution() - radius);
    const double likely = 1.0 - std::exp(-away / kShyness);
    strength.cells[i] =
        static_cast<float>(likely * likely) * (loss.across_x.cells[i] + loss.across_y.cells[i]);
  }
  return strength;
}

}  // namespace

WallField estimateWalls(const GridGeometry& geometry, const std::vector<HeardAccessPoint>& heard,
                        const Mask& path, double robot_radius, const WallFieldConfig& config,
                        const std::atomic<bool>& stop) {
  WallField result{LineField(geometry), Grid<float>(geometry), {}};
  for (const HeardAccessPoint& one : heard) {
    result.ray_loss.emplace_back(one.bins.size(), 0.0);
  }
  const Grid<double> distance = distanceTransform(path);
  const double share = 1.0 / config.members;
  for (int member = 0; member < config.members && !stop; ++member) {
    const GridGeometry lattice = shifted(geometry, config.line_resolution, member);
    const LineField field =
        solveLineField(lattice, heardBy(member, heard, config),
                       coarsened(distance, lattice, robot_radius), config.line, stop);
    addTo(result.loss, field, static_cast<float>(share));
    for (std::size_t i = 0; i < heard.size(); ++i) {
      for (std::size_t j = 0; j < heard[i].bins.size() && !stop; ++j) {
        result.ray_loss[i][j] +=
            share * lossBetween(field, heard[i].position, heard[i].bins[j].place);
      }
    }
  }
  result.strength = strengthOf(result.loss, distance, robot_radius);
  return result;
}

}  // namespace sfw
