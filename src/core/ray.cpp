#include "structure_from_wifi/ray.h"

#include <algorithm>

namespace sfw {
namespace {

/// The nearest sub-cell that is strictly inside the cell which holds the coordinate.
std::int64_t snap(double cells, std::int64_t subcells) {
  const auto cell = static_cast<std::int64_t>(std::floor(cells));
  const auto nearest =
      static_cast<std::int64_t>(std::llround(cells * static_cast<double>(subcells)));
  return std::clamp(nearest, cell * subcells + 1, (cell + 1) * subcells - 1);
}

}  // namespace

Ray::Ray(const GridGeometry& geometry, const Position& from, const Position& to) {
  constexpr std::int64_t kSubcells = std::int64_t{1} << kSubcellBits;
  const Position a = geometry.toCells(from);
  const Position b = geometry.toCells(to);
  from_x_ = snap(a.x(), kSubcells);
  from_y_ = snap(a.y(), kSubcells);
  to_x_ = snap(b.x(), kSubcells);
  to_y_ = snap(b.y(), kSubcells);
}

}  // namespace sfw
