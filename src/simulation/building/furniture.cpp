#include "simulation/building/furniture.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/random_streams.h"
#include "grid/for_each_cell.h"
#include "grid/segment.h"

namespace sfw {
namespace {

std::vector<Cell> freeCells(const FloorPlan& plan) {
  std::vector<Cell> cells;
  forEachCell(plan.geometry, [&](Cell c) {
    if (plan[c] == Material::kFree) {
      cells.push_back(c);
    }
  });
  return cells;
}

}  // namespace

std::vector<Furniture> placeFurniture(const FloorPlan& plan, double max_loss_db,
                                      double area_per_piece_m2, std::int64_t seed) {
  constexpr double kLeastRadius = 0.2, kMostRadius = 0.5;  // metres: a chair to a wardrobe
  const std::vector<Cell> free = freeCells(plan);
  const double cell_m2 = plan.geometry.resolution() * plan.geometry.resolution();
  const double area_m2 = static_cast<double>(free.size()) * cell_m2;
  std::vector<Furniture> pieces(static_cast<std::size_t>(area_m2 / area_per_piece_m2));
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Random random(seed, streamOf(Purpose::kFurniture), i);
    const double at = (1.0 - random.uniform()) * static_cast<double>(free.size());
    pieces[i].centre = plan.geometry.centre(free[static_cast<std::size_t>(at)]);
    pieces[i].radius_m = random.uniform(kLeastRadius, kMostRadius);
    pieces[i].loss_db = random.uniform(0.0, max_loss_db);
  }
  return pieces;
}

double furnitureLoss(const std::vector<Furniture>& pieces, const Position& from,
                     const Position& to) {
  double loss_db = 0.0;
  for (const Furniture& piece : pieces) {
    if (distanceToSegment(piece.centre, from, to) < piece.radius_m) {
      loss_db += piece.loss_db;
    }
  }
  return loss_db;
}

}  // namespace sfw
