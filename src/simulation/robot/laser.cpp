#include "simulation/robot/laser.h"

#include <cmath>
#include <limits>

#include "base/constants.h"
#include "grid/ray.h"
#include "simulation/robot/box_entry.h"

namespace sfw {
namespace {

double rangeAlong(const Grid<CellState>& plan, const Position& from, const Position& direction,
                  double range_m) {
  const GridGeometry& geometry = plan.geometry;
  // A beam along the edge of two cells meets both.
  constexpr double kRounding = 1e-10;  // [m]
  const Position half_cell = Position::Constant(0.5 * geometry.resolution() + kRounding);
  double range = std::numeric_limits<double>::infinity();
  Ray(geometry, from, from + range_m * direction).forEachCellWhile([&](Cell cell) {
    if (geometry.contains(cell) && plan[cell] == CellState::kFree) {
      return true;
    }
    const Position centre = geometry.centre(cell);
    const double entry = entryIntoBox(from, direction, Box(centre - half_cell, centre + half_cell));
    range = entry <= range_m ? entry : range;
    // The ray's ends are rounded, so it may name a cell whose corner the beam just misses.
    return std::isinf(entry);
  });
  return range;
}

}  // namespace

double beamBearing(const LaserConfig& config, std::int64_t beam) {
  return -kPi + 2.0 * kPi * static_cast<double>(beam) / static_cast<double>(config.beams);
}

std::vector<double> laserRanges(const Grid<CellState>& plan, const RobotPose& pose,
                                const LaserConfig& config) {
  std::vector<double> ranges;
  for (std::int64_t beam = 0; beam < config.beams; ++beam) {
    const double bearing = pose.yaw_rad + beamBearing(config, beam);
    ranges.push_back(
        rangeAlong(plan, pose.position, {std::cos(bearing), std::sin(bearing)}, config.range_m));
  }
  return ranges;
}

}  // namespace sfw
