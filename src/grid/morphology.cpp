#include "grid/morphology.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "grid/distance_transform.h"
#include "grid/for_each_cell.h"
#include "grid/near_squares.h"

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

/// The largest square of a distance between cells that is not longer than a radius.
std::int16_t largestSquare(double radius_cells) {
  auto square = static_cast<std::int16_t>(radius_cells * radius_cells);
  while (std::sqrt(static_cast<double>(square + 1)) <= radius_cells) {
    ++square;
  }
  while (std::sqrt(static_cast<double>(square)) > radius_cells) {
    --square;
  }
  return square;
}

/// The cells outside a set that are connected with the border of the grid, edge to edge.
Mask outsideOf(const Mask& set) {
  const GridGeometry& geometry = set.geometry;
  const auto width = static_cast<std::size_t>(geometry.width());
  // A frame around the grid spares the tests of its border.
  const std::size_t stride = width + 2;
  const auto height = static_cast<std::size_t>(geometry.height());
  std::vector<std::uint8_t> closed(stride * (height + 2), 1);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      closed[(y + 1) * stride + x + 1] = set.cells[y * width + x] != 0 ? 1 : 0;
    }
  }
  constexpr std::uint8_t kOutside = 2;
  std::vector<std::size_t> open;
  const auto visit = [&](std::size_t at) {
    if (closed[at] == 0) {
      closed[at] = kOutside;
      open.push_back(at);
    }
  };
  for (std::size_t x = 1; x <= width; ++x) {
    visit(stride + x);
    visit(height * stride + x);
  }
  for (std::size_t y = 1; y <= height; ++y) {
    visit(y * stride + 1);
    visit(y * stride + width);
  }
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    visit(at - 1);
    visit(at + 1);
    visit(at - stride);
    visit(at + stride);
  }
  Mask outside(geometry);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      outside.cells[y * width + x] = closed[(y + 1) * stride + x + 1] == kOutside ? 1 : 0;
    }
  }
  return outside;
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
  Mask result(mask.geometry);
  if (radius_cells >= 0.0 && radius_cells < static_cast<double>(kFarthestNear + 1)) {
    const auto reach = static_cast<std::int64_t>(radius_cells);
    const std::int16_t largest = largestSquare(radius_cells);
    const Grid<std::int16_t> squares = nearSquares(mask, reach);
    std::transform(squares.cells.begin(), squares.cells.end(), result.cells.begin(),
                   [&](std::int16_t square) { return square <= largest ? 1 : 0; });
    return result;
  }
  const Grid<double> distance = distanceTransform(mask);
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
  const Mask not_deep = dilated(complement(wide), radius_cells);
  Mask result(mask.geometry);
  forEachCell(mask.geometry, [&](Cell c) {
    result[c] = not_deep[{c.x + margin, c.y + margin}] != 0 ? 0 : 1;
  });
  return result;
}

Mask withHolesFilled(const Mask& mask) { return complement(outsideOf(mask)); }

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
