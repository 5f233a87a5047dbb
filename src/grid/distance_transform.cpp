#include "grid/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sfw {
namespace {

/// Longer than any distance within the grid.
std::int64_t beyond(const GridGeometry& geometry) { return geometry.width() + geometry.height(); }

/// Distance to the nearest set cell of the same column, `beyond` if it has none.
Grid<std::int64_t> distanceInColumn(const Mask& mask) {
  const GridGeometry& geometry = mask.geometry;
  const std::int64_t none = beyond(geometry);
  Grid<std::int64_t> distance(geometry, none);
  const auto width = static_cast<std::size_t>(geometry.width());
  const std::size_t size = geometry.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (mask.cells[i] != 0) {
      distance.cells[i] = 0;
    } else if (i >= width) {
      distance.cells[i] = std::min(none, distance.cells[i - width] + 1);
    }
  }
  for (std::size_t i = size - width; i-- > 0;) {
    distance.cells[i] = std::min(distance.cells[i], distance.cells[i + width] + 1);
  }
  return distance;
}

/// The lower envelope of the parabolas x -> (x - i)^2 + g(i)^2 along one row.
class RowEnvelope {
 public:
  explicit RowEnvelope(std::int64_t width) : width_(width) {
    vertex_.reserve(static_cast<std::size_t>(width));
    start_.reserve(static_cast<std::size_t>(width));
  }

  /// @param g  distances within the columns of the row
  void build(const std::int64_t* g) {
    g_ = g;
    vertex_.assign(1, 0);
    start_.assign(1, 0);
    for (std::int64_t x = 1; x < width_; ++x) {
      add(x);
    }
  }

  /// Writes the squared distances of the row.
  template <class Write>
  void evaluate(Write&& write) const {
    std::size_t piece = vertex_.size() - 1;
    for (std::int64_t x = width_ - 1; x >= 0; --x) {
      write(x, parabola(x, vertex_[piece]));
      if (x == start_[piece] && piece > 0) {
        --piece;
      }
    }
  }

 private:
  std::int64_t parabola(std::int64_t x, std::int64_t vertex) const {
    return (x - vertex) * (x - vertex) + g_[vertex] * g_[vertex];
  }

  void add(std::int64_t x) {
    if (!vertex_.empty() && vertex_.back() == x - 1 && start_.back() < x && g_[x] == g_[x - 1]) {
      vertex_.push_back(x);  // as below, without the division; most cells are like this
      start_.push_back(x);
      return;
    }
    while (!vertex_.empty() &&
           parabola(start_.back(), vertex_.back()) > parabola(start_.back(), x)) {
      vertex_.pop_back();
      start_.pop_back();
    }
    std::int64_t start = 0;
    if (!vertex_.empty()) {
      // The division gives the last whole x at which the previous piece is not above. Its dividend
      // is not negative, because that piece is not above at its own start.
      const std::int64_t before = vertex_.back();
      start = 1 + (parabola(0, x) - parabola(0, before)) / (2 * (x - before));
    }
    if (start < width_) {
      vertex_.push_back(x);
      start_.push_back(start);
    }
  }

  std::int64_t width_;
  const std::int64_t* g_ = nullptr;
  std::vector<std::int64_t> vertex_;
  std::vector<std::int64_t> start_;  // the first x of each piece
};

}  // namespace

Grid<double> distanceTransform(const Mask& mask) {
  const GridGeometry& geometry = mask.geometry;
  const Grid<std::int64_t> in_column = distanceInColumn(mask);
  const std::int64_t none = beyond(geometry) * beyond(geometry);
  Grid<double> distance(geometry);
  RowEnvelope envelope(geometry.width());
  for (std::int64_t y = 0; y < geometry.height(); ++y) {
    envelope.build(&in_column[{0, y}]);
    envelope.evaluate([&](std::int64_t x, std::int64_t squared) {
      distance[{x, y}] = squared < none ? std::sqrt(static_cast<double>(squared))
                                        : std::numeric_limits<double>::infinity();
    });
  }
  return distance;
}

}  // namespace sfw
