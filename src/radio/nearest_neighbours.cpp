#include "radio/nearest_neighbours.h"

#include <algorithm>
#include <cmath>

namespace sfw {
namespace {

/// Edge of a cell, in spacings of the positions. With four positions in a cell, searches among few
/// of them look at few cells, and searches among all of them look at few positions.
constexpr double kCellEdge = 2.0;

}  // namespace

NearestNeighbours::NearestNeighbours(const std::vector<Position>& positions)
    : positions_(positions), next_(positions.size(), -1) {
  Box box;
  for (const Position& position : positions) {
    box.extend(position);
  }
  if (!box.isEmpty()) {
    const auto count = static_cast<double>(positions.size());
    const Position size = box.sizes();
    least_ = box.min();
    // The second value bounds the number of cells if all positions lie on a line.
    const double edge =
        kCellEdge * std::max(std::sqrt(size.prod() / count), size.maxCoeff() / count);
    edge_ = edge > 0.0 ? edge : 1.0;
    width_ = cellOf(box.max().x(), least_.x()) + 1;
    height_ = cellOf(box.max().y(), least_.y()) + 1;
  }
  first_.assign(static_cast<std::size_t>(width_ * height_), -1);
}

std::int64_t NearestNeighbours::cellOf(double coordinate, double least) const {
  return static_cast<std::int64_t>(std::floor((coordinate - least) / edge_));
}

void NearestNeighbours::enter(int number) {
  const Position& position = positions_[static_cast<std::size_t>(number)];
  int& first = first_[static_cast<std::size_t>(cellOf(position.y(), least_.y()) * width_ +
                                               cellOf(position.x(), least_.x()))];
  next_[static_cast<std::size_t>(number)] = first;
  first = number;
}

void NearestNeighbours::lookIn(std::int64_t x, std::int64_t y, const Position& to,
                               std::size_t count) {
  for (int number = first_[static_cast<std::size_t>(y * width_ + x)]; number >= 0;
       number = next_[static_cast<std::size_t>(number)]) {
    const std::pair<double, int> one(
        (positions_[static_cast<std::size_t>(number)] - to).squaredNorm(), number);
    if (found_.size() == count && !(one < found_.back())) {
      continue;
    }
    if (found_.size() < count) {
      found_.emplace_back();
    }
    std::size_t at = found_.size() - 1;
    for (; at > 0 && one < found_[at - 1]; --at) {
      found_[at] = found_[at - 1];
    }
    found_[at] = one;
  }
}

void NearestNeighbours::lookInRing(std::int64_t x, std::int64_t y, std::int64_t ring,
                                   const Position& to, std::size_t count) {
  const std::int64_t bottom = std::max<std::int64_t>(y - ring, 0);
  const std::int64_t top = std::min(y + ring, height_ - 1);
  for (std::int64_t row = bottom; row <= top; ++row) {
    // The lowest and highest rows are complete. The other rows have only their two end cells.
    if (row == y - ring || row == y + ring) {
      const std::int64_t right = std::min(x + ring, width_ - 1);
      for (std::int64_t column = std::max<std::int64_t>(x - ring, 0); column <= right; ++column) {
        lookIn(column, row, to, count);
      }
      continue;
    }
    for (const std::int64_t column : {x - ring, x + ring}) {
      if (column >= 0 && column < width_) {
        lookIn(column, row, to, count);
      }
    }
  }
}

const std::vector<std::pair<double, int>>& NearestNeighbours::nearest(const Position& to,
                                                                      std::size_t count) {
  found_.clear();
  const std::int64_t x = cellOf(to.x(), least_.x());
  const std::int64_t y = cellOf(to.y(), least_.y());
  const std::int64_t last =
      std::max({std::abs(x), std::abs(y), std::abs(width_ - 1 - x), std::abs(height_ - 1 - y)});
  for (std::int64_t ring = 0; ring <= last && count > 0; ++ring) {
    lookInRing(x, y, ring, to, count);
    // All positions not visited yet are farther than this ring, except for rounding.
    constexpr double kRounding = 1e-6;
    const double seen = (static_cast<double>(ring) - kRounding) * edge_;
    if (found_.size() == count && seen > 0.0 && found_.back().first < seen * seen) {
      break;
    }
  }
  return found_;
}

}  // namespace sfw
