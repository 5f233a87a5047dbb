#include "grid/ray.h"

#include <algorithm>

namespace sfw {

/// The nearest sub-cell that is strictly inside the cell which holds the coordinate.
std::int64_t Ray::snapped(double cells) {
  const auto cell = static_cast<std::int64_t>(std::floor(cells));
  const auto nearest =
      static_cast<std::int64_t>(std::llround(cells * static_cast<double>(kSubcells)));
  return std::clamp(nearest, cell * kSubcells + 1, (cell + 1) * kSubcells - 1);
}

Ray::Ray(const GridGeometry& geometry, const Position& from, const Position& to) {
  const Position a = geometry.toCells(from);
  const Position b = geometry.toCells(to);
  from_x_ = snapped(a.x());
  from_y_ = snapped(a.y());
  to_x_ = snapped(b.x());
  to_y_ = snapped(b.y());
}

}  // namespace sfw
