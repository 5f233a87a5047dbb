#include "training/clearance.h"

#include "grid/distance_transform.h"

namespace sfw {
namespace {

Grid<double> distanceToObstacles(const FloorPlan& plan) {
  Mask obstacles(plan.geometry);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    obstacles.cells[i] = plan.cells[i] == Material::kFree ? 0 : 1;
  }
  return distanceTransform(obstacles);
}

}  // namespace

Clearance::Clearance(const FloorPlan& plan, double least_m)
    : distance_(distanceToObstacles(plan)), least_m_(least_m) {}

bool Clearance::allows(const Position& from, const Position& to) const {
  const double length = (to - from).norm();
  const int steps = 1 + static_cast<int>(length / distance_.geometry.resolution());
  for (int i = 0; i <= steps; ++i) {
    const Position position = from + (to - from) * (static_cast<double>(i) / steps);
    if (at(distance_.geometry.cellAt(position)) < least_m_) {
      return false;
    }
  }
  return true;
}

}  // namespace sfw
