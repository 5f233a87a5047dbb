#include "path/path_style.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "grid/ray.h"

namespace sfw {
namespace {

/// A straight piece of the path.
struct Piece {
  Position from = Position::Zero();
  Position to = Position::Zero();
  double at_m = 0.0;  ///< distance driven up to its middle
  double length_m = 0.0;
  double fit = 0.0;        ///< cosine of four times its heading
  bool continues = false;  ///< no gap since the piece before
};

std::vector<Piece> piecesOf(const std::vector<Position>& driven, double least_m, double max_gap_m) {
  // A gap: longer than any stretch over which pieces are compared.
  constexpr double kGapLength = 10.0;
  std::vector<Piece> pieces;
  double driven_m = 0.0;
  bool continues = false;
  Position from = driven.front();
  Position last = from;
  for (const Position& position : driven) {
    const bool gap = (position - last).norm() > max_gap_m;
    last = position;
    if (gap) {
      driven_m += kGapLength;
      continues = false;
      from = position;
      continue;
    }
    const Position step = position - from;
    const double length = step.norm();
    if (length >= least_m) {
      pieces.push_back({from, position, driven_m + 0.5 * length, length,
                        std::cos(4.0 * std::atan2(step.y(), step.x())), continues});
      driven_m += length;
      continues = true;
      from = position;
    }
  }
  return pieces;
}

double rimShareOf(const Mask& path, const Grid<float>& enclosed_depth_m) {
  constexpr float kAtRim = 0.15F;  // [m]
  double cells = 0.0;
  double at_rim = 0.0;
  for (std::size_t i = 0; i < path.cells.size(); ++i) {
    if (path.cells[i] != 0) {
      cells += 1.0;
      at_rim += enclosed_depth_m.cells[i] <= kAtRim ? 1.0 : 0.0;
    }
  }
  return cells > 0.0 ? at_rim / cells : 0.0;
}

/// The headings of shorter pieces suffer from the jitter of poses [m].
constexpr double kHeadingPiece = 0.1;

}  // namespace

PathStyle measurePathStyle(const Mask& path, const Grid<float>& enclosed_depth_m,
                           const std::vector<Position>& driven, double max_gap_m) {
  PathStyle style;
  style.rim_share = rimShareOf(path, enclosed_depth_m);
  double length = 0.0;
  for (const Piece& piece : piecesOf(driven, kHeadingPiece, max_gap_m)) {
    style.axis_share += piece.length_m * piece.fit;
    length += piece.length_m;
  }
  style.axis_share /= std::max(length, kHeadingPiece);
  constexpr double kTurnPiece = 0.3;  // [m]
  const std::vector<Piece> pieces = piecesOf(driven, kTurnPiece, max_gap_m);
  double turns = 0.0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].continues) {
      const Position before = (pieces[i - 1].to - pieces[i - 1].from).normalized();
      const Position after = (pieces[i].to - pieces[i].from).normalized();
      style.winding += 0.5 * (1.0 - before.dot(after));
      turns += 1.0;
    }
  }
  style.winding /= std::max(turns, 1.0);
  return style;
}

Grid<float> axisAlignment(const GridGeometry& geometry, const std::vector<Position>& driven,
                          double max_gap_m) {
  constexpr double kStretch = 0.75;  // [m] to each side
  const std::vector<Piece> pieces = piecesOf(driven, kHeadingPiece, max_gap_m);
  Grid<float> alignment(geometry);
  Grid<float> passes(geometry);
  std::size_t low = 0;
  std::size_t high = 0;
  for (const Piece& piece : pieces) {
    while (high < pieces.size() && pieces[high].at_m <= piece.at_m + kStretch) {
      ++high;
    }
    while (pieces[low].at_m < piece.at_m - kStretch) {
      ++low;
    }
    double fit = 0.0;
    double length = 0.0;
    for (std::size_t i = low; i < high; ++i) {
      fit += pieces[i].length_m * pieces[i].fit;
      length += pieces[i].length_m;
    }
    Ray(geometry, piece.from, piece.to).forEachCell([&](Cell c) {
      if (geometry.contains(c)) {
        alignment[c] += static_cast<float>(fit / length);
        passes[c] += 1.0F;
      }
    });
  }
  for (std::size_t i = 0; i < alignment.cells.size(); ++i) {
    alignment.cells[i] /= std::max(passes.cells[i], 1.0F);
  }
  return alignment;
}

}  // namespace sfw
