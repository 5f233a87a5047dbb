#include "walls/wall_segments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "base/median.h"

namespace sfw {
namespace {

/// Width of the band of a straight piece [cells].
constexpr std::int64_t kBand = 3;

/// Successive cells of a wall that lie in a band.
class Piece {
 public:
  explicit Piece(Cell first) : cells_{first}, low_(first), high_(first) {}

  /// Adds the next cell, if it continues the piece.
  bool add(Cell next) {
    const Cell low{std::min(low_.x, next.x), std::min(low_.y, next.y)};
    const Cell high{std::max(high_.x, next.x), std::max(high_.y, next.y)};
    const Cell last = cells_.back();
    const bool behind_gap = std::abs(next.x - last.x) > 1 || std::abs(next.y - last.y) > 1;
    if (behind_gap || std::min(high.x - low.x, high.y - low.y) >= kBand) {
      return false;
    }
    low_ = low;
    high_ = high;
    cells_.push_back(next);
    return true;
  }

  /// The ends of the piece in metres, in the frame of the grid.
  std::pair<Position, Position> ends(const GridGeometry& geometry) const {
    const auto in_metres = [&](double x, double y) -> Position {
      return geometry.origin() + geometry.resolution() * Position(x, y);
    };
    const Position centre = Position(medianOf(&Cell::x), medianOf(&Cell::y)).array() + 0.5;
    const Position low(static_cast<double>(low_.x), static_cast<double>(low_.y));
    const Position high(static_cast<double>(high_.x + 1), static_cast<double>(high_.y + 1));
    if (high_.x - low_.x > high_.y - low_.y) {
      return {in_metres(low.x(), centre.y()), in_metres(high.x(), centre.y())};
    }
    return {in_metres(centre.x(), low.y()), in_metres(centre.x(), high.y())};
  }

 private:
  double medianOf(std::int64_t Cell::*coordinate) const {
    std::vector<std::int64_t> values;
    for (const Cell& c : cells_) {
      values.push_back(c.*coordinate);
    }
    return static_cast<double>(median(std::move(values)));
  }

  std::vector<Cell> cells_;
  Cell low_;   // the lower left cell of the rectangle around all
  Cell high_;  // the upper right one
};

}  // namespace

std::vector<WallSegment> straightPieces(const StripWall& wall, const GridGeometry& geometry) {
  std::vector<Piece> pieces;
  for (const Cell c : wall.cells) {
    if (pieces.empty() || !pieces.back().add(c)) {
      pieces.emplace_back(c);
    }
  }
  std::vector<WallSegment> segments;
  for (const Piece& piece : pieces) {
    const auto [from, to] = piece.ends(geometry);
    segments.push_back({from, to, -std::expm1(-wall.expected), wall.is_outer});
  }
  return segments;
}

}  // namespace sfw
