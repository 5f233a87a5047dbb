#include "grid/morphology.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"

namespace sfw {
namespace {

/// The set on a grid that is wider by `margin` cells on each side.
Mask padded(const Mask& mask, std::int64_t margin) {
  const GridGeometry& inner = mask.geometry;
  const double shift = inner.resolution() * static_cast<double>(margin);
  Mask outer(GridGeometry(inner.resolution(), inner.origin() - Position(shift, shift),
                          inner.width() + 2 * margin, inner.height() + 2 * margin));
  forEachCell(inner, [&](Cell c) { outer[{c.x + margin, c.y + margin}] = mask[c]; });
  return outer;
}

/// Labels all cells of the set that are connected with `seed`.
void flood(const Mask& mask, Connectivity connectivity, Cell seed, std::int64_t label,
           Grid<std::int64_t>& labels) {
  std::vector<Cell> open{seed};
  labels[seed] = label;
  while (!open.empty()) {
    const Cell at = open.back();
    open.pop_back();
    const auto visit = [&](Cell next) {
      if (mask.geometry.contains(next) && mask[next] != 0 && labels[next] == 0) {
        labels[next] = label;
        open.push_back(next);
      }
    };
    for (const std::int64_t step : {-1, 1}) {
      visit({at.x + step, at.y});
      visit({at.x, at.y + step});
      if (connectivity == Connectivity::kEdgesAndCorners) {
        visit({at.x + step, at.y + step});
        visit({at.x + step, at.y - step});
      }
    }
  }
}

/// Whether each label of a set occurs on the grid's border.
std::vector<bool> touchesBorder(const Components& components) {
  const GridGeometry& geometry = components.label.geometry;
  std::vector<bool> touches(static_cast<std::size_t>(components.count) + 1, false);
  const auto note = [&](Cell c) { touches[static_cast<std::size_t>(components.label[c])] = true; };
  for (std::int64_t x = 0; x < geometry.width(); ++x) {
    note({x, 0});
    note({x, geometry.height() - 1});
  }
  for (std::int64_t y = 0; y < geometry.height(); ++y) {
    note({0, y});
    note({geometry.width() - 1, y});
  }
  return touches;
}

}  // namespace

Mask complement(const Mask& mask) {
  Mask others(mask.geometry);
  for (std::size_t i = 0; i < mask.cells.size(); ++i) {
    others.cells[i] = mask.cells[i] == 0 ? 1 : 0;
  }
  return others;
}

Mask dilated(const Mask& mask, double radius_cells) {
  const Grid<double> distance = distanceTransform(mask);
  Mask result(mask.geometry);
  for (std::size_t i = 0; i < mask.cells.size(); ++i) {
    result.cells[i] = distance.cells[i] <= radius_cells ? 1 : 0;
  }
  return result;
}

Mask closed(const Mask& mask, double radius_cells) {
  if (!(radius_cells >= 0.0 && radius_cells < static_cast<double>(1 << 18))) {
    throw std::invalid_argument("radius_cells must lie in 0..262143");
  }
  // Wide enough that the dilated set never reaches the padded grid's border.
  const std::int64_t margin = static_cast<std::int64_t>(std::ceil(radius_cells)) + 1;
  const Mask wide = dilated(padded(mask, margin), radius_cells);
  const Grid<double> depth = distanceTransform(complement(wide));
  Mask result(mask.geometry);
  forEachCell(mask.geometry, [&](Cell c) {
    result[c] = depth[{c.x + margin, c.y + margin}] > radius_cells ? 1 : 0;
  });
  return result;
}

Mask withHolesFilled(const Mask& mask) {
  const Components outside = labelComponents(complement(mask));
  const std::vector<bool> open = touchesBorder(outside);
  Mask result(mask.geometry);
  for (std::size_t i = 0; i < mask.cells.size(); ++i) {
    const std::int64_t label = outside.label.cells[i];
    result.cells[i] = label == 0 || !open[static_cast<std::size_t>(label)] ? 1 : 0;
  }
  return result;
}

Components labelComponents(const Mask& mask, Connectivity connectivity) {
  Components components{Grid<std::int64_t>(mask.geometry, 0), 0};
  forEachCell(mask.geometry, [&](Cell c) {
    if (mask[c] != 0 && components.label[c] == 0) {
      flood(mask, connectivity, c, ++components.count, components.label);
    }
  });
  return components;
}

}  // namespace sfw
