#include "grid/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sfw {
namespace {

/// Longer than any distance within the grid.
std::int64_t beyond(const GridGeometry& geometry) { return geometry.width() + geometry.height(); }

/// Distance to the nearest set cell of the same column, `beyond` if it has none; row-major.
template <class Int>
std::vector<Int> distanceInColumn(const Mask& mask) {
  const GridGeometry& geometry = mask.geometry;
  const auto none = static_cast<Int>(beyond(geometry));
  const auto width = static_cast<std::size_t>(geometry.width());
  const std::size_t size = geometry.size();
  std::vector<Int> distance(size, none);
  for (std::size_t i = 0; i < width; ++i) {
    distance[i] = mask.cells[i] != 0 ? 0 : none;
  }
  for (std::size_t i = width; i < size; ++i) {
    const Int beside = std::min<Int>(none, distance[i - width] + 1);
    distance[i] = mask.cells[i] != 0 ? 0 : beside;
  }
  for (std::size_t i = size - width; i-- > 0;) {
    distance[i] = std::min<Int>(distance[i], distance[i + width] + 1);
  }
  return distance;
}

/// The lower envelope of the parabolas x -> (x - i)^2 + g(i)^2 along one row.
/// @tparam Int  holds twice the square of `beyond`
template <class Int>
class RowEnvelope {
 public:
  explicit RowEnvelope(Int width) : width_(width) {
    vertex_.reserve(static_cast<std::size_t>(width));
    start_.reserve(static_cast<std::size_t>(width));
  }

  /// @param g  distances within the columns of the row
  void build(const Int* g) {
    g_ = g;
    vertex_.assign(1, 0);
    start_.assign(1, 0);
    for (Int x = 1; x < width_; ++x) {
      add(x);
    }
  }

  /// Writes the squared distances of the row.
  template <class Write>
  void evaluate(Write&& write) const {
    std::size_t piece = vertex_.size() - 1;
    for (Int x = width_ - 1; x >= 0; --x) {
      write(x, parabola(x, vertex_[piece]));
      if (x == start_[piece] && piece > 0) {
        --piece;
      }
    }
  }

 private:
  Int parabola(Int x, Int vertex) const {
    return (x - vertex) * (x - vertex) + g_[vertex] * g_[vertex];
  }

  void add(Int x) {
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
    Int start = 0;
    if (!vertex_.empty()) {
      // The division gives the last whole x at which the previous piece is not above. Its dividend
      // is not negative, because that piece is not above at its own start.
      const Int before = vertex_.back();
      start = 1 + (parabola(0, x) - parabola(0, before)) / (2 * (x - before));
    }
    if (start < width_) {
      vertex_.push_back(x);
      start_.push_back(start);
    }
  }

  Int width_;
  const Int* g_ = nullptr;
  std::vector<Int> vertex_;
  std::vector<Int> start_;  // the first x of each piece
};

/// As distanceTransform, in whole numbers that are wide enough.
template <class Int>
void transform(const Mask& mask, Grid<double>& distance) {
  const GridGeometry& geometry = mask.geometry;
  const std::vector<Int> in_column = distanceInColumn<Int>(mask);
  const auto longest = static_cast<Int>(beyond(geometry));
  const Int none = longest * longest;
  const auto width = static_cast<std::size_t>(geometry.width());
  RowEnvelope<Int> envelope(static_cast<Int>(geometry.width()));
  for (std::size_t first = 0; first < distance.cells.size(); first += width) {
    double* const row = distance.cells.data() + first;
    envelope.build(in_column.data() + first);
    envelope.evaluate([&](Int x, Int squared) {
      row[x] = squared < none ? std::sqrt(static_cast<double>(squared))
                              : std::numeric_limits<double>::infinity();
    });
  }
}

}  // namespace

Grid<double> distanceTransform(const Mask& mask) {
  constexpr std::int64_t kLongestIn32Bits = 32767;
  Grid<double> distance(mask.geometry);
  if (beyond(mask.geometry) <= kLongestIn32Bits) {
    transform<std::int32_t>(mask, distance);
  } else {
    transform<std::int64_t>(mask, distance);
  }
  return distance;
}

}  // namespace sfw
