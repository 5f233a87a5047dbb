#include "structure_from_wifi/grid_geometry.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sfw {
namespace {

// Keeps coordinates in the range in which Ray is exact, and the product in 64 bits.
constexpr std::int64_t kMaxSide = std::int64_t{1} << 18;

bool isPositive(double value) { return std::isfinite(value) && value > 0.0; }

void requirePositive(double value, const char* name) {
  if (!isPositive(value)) {
    throw std::invalid_argument(std::string(name) + " must be finite and positive");
  }
}

/// A grid in units of cells, in floating point, so that nothing overflows before it is compared.
struct Lattice {
  Position first;  // column and row of the first cell, from the frame's origin
  Position cells;  // width and height
};

Lattice latticeAround(const Box& box, double resolution_m, double step_m) {
  const double cells_a_step = std::max(1.0, std::round(step_m / resolution_m));
  const double step = cells_a_step * resolution_m;
  Position first = (box.min() / step).array().floor();
  Position last = (box.max() / step).array().floor() + 1.0;
  // Rounding must not exclude a corner on a step's border.
  constexpr double kRounding = 1e-9;  // [steps]
  for (int axis = 0; axis < 2; ++axis) {
    first[axis] -= first[axis] * cells_a_step * resolution_m > box.min()[axis] ? 1.0 : 0.0;
    last[axis] += last[axis] - box.max()[axis] / step <= kRounding ? 1.0 : 0.0;
  }
  return {first * cells_a_step, (last - first) * cells_a_step};
}

bool isFinite(const Box& box) {
  return !box.isEmpty() && box.min().allFinite() && box.max().allFinite();
}

bool isTooLarge(const Lattice& lattice, std::int64_t max_cells) {
  // NaN, as infinity less infinity, is too large as well.
  return !(lattice.cells.x() * lattice.cells.y() <= static_cast<double>(max_cells));
}

bool isTooFar(const Lattice& lattice) {
  return lattice.first.cwiseAbs().maxCoeff() > GridGeometry::kFarthestMap;
}

}  // namespace

GridGeometry::GridGeometry(double resolution_m, const Position& origin, std::int64_t width,
                           std::int64_t height)
    : resolution_m_(resolution_m), origin_(origin), width_(width), height_(height) {
  requirePositive(resolution_m, "resolution_m");
  if (!origin.allFinite()) {
    throw std::invalid_argument("origin must be finite");
  }
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    throw std::invalid_argument("width and height must lie in 1..262144 cells");
  }
}

GridGeometry GridGeometry::covering(const Box& box, double resolution_m, double step_m,
                                    std::int64_t max_cells) {
  requirePositive(resolution_m, "resolution_m");
  requirePositive(step_m, "step_m");
  if (!isFinite(box)) {
    throw std::invalid_argument("box must be finite and not empty");
  }
  const Lattice lattice = latticeAround(box, resolution_m, step_m);
  if (isTooLarge(lattice, max_cells)) {
    throw std::invalid_argument("the grid would have more than max_cells cells");
  }
  if (isTooFar(lattice)) {
    throw std::invalid_argument("the grid would lie over 2097152 cells from the frame's origin");
  }
  const Position origin = lattice.first * resolution_m;
  return {resolution_m, origin, static_cast<std::int64_t>(lattice.cells.x()),
          static_cast<std::int64_t>(lattice.cells.y())};
}

bool GridGeometry::canCover(const Box& box, double resolution_m, double step_m,
                            std::int64_t max_cells) {
  if (!isPositive(resolution_m) || !isPositive(step_m) || !isFinite(box)) {
    return false;
  }
  const Lattice lattice = latticeAround(box, resolution_m, step_m);
  return !isTooLarge(lattice, max_cells) && !isTooFar(lattice) &&
         lattice.cells.maxCoeff() <= static_cast<double>(kMaxSide) &&
         (lattice.first * resolution_m).allFinite();
}

Cell GridGeometry::cellAt(const Position& point) const {
  const Position cells = toCells(point).array().floor();
  return {static_cast<std::int64_t>(cells.x()), static_cast<std::int64_t>(cells.y())};
}

Position GridGeometry::centre(Cell c) const {
  return origin_ +
         resolution_m_ * Position(static_cast<double>(c.x) + 0.5, static_cast<double>(c.y) + 0.5);
}

Box GridGeometry::box() const {
  return {origin_, origin_ + resolution_m_ * Position(static_cast<double>(width_),
                                                      static_cast<double>(height_))};
}

Cell latticeCell(const GridGeometry& geometry) {
  return {std::llround(geometry.origin().x() / geometry.resolution()),
          std::llround(geometry.origin().y() / geometry.resolution())};
}

bool octomapReaches(const GridGeometry& geometry) {
  const Cell first = latticeCell(geometry);
  return std::min(first.x, first.y) >= -kOctomapReach &&
         std::max(first.x + geometry.width(), first.y + geometry.height()) <= kOctomapReach;
}

}  // namespace sfw
