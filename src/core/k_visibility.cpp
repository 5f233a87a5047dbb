#include "structure_from_wifi/k_visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "structure_from_wifi/ray.h"

namespace sfw {
namespace {

/// What rays of neighbouring slopes have met so far, up to a slope where that changes.
struct Piece {
  double end_slope;
  int walls;
  bool in_wall;
};

/// Wall cells side by side in one row: positions across the cone, [begin, end).
struct Run {
  double begin;
  double end;
};

/// Walks over a row's runs from low to high positions.
class RunCursor {
 public:
  explicit RunCursor(const std::vector<Run>& runs) : run_(runs.begin()), end_(runs.end()) {}

  /// Whether a wall stands at a position, which must not be lower than the last one asked for.
  bool isWall(double position) {
    while (run_ != end_ && run_->end <= position) {
      ++run_;
    }
    return run_ != end_ && run_->begin <= position;
  }

  /// Where that changes next; infinity if it never does.
  double change(bool is_wall) const {
    return run_ == end_ ? std::numeric_limits<double>::infinity()
                        : (is_wall ? run_->end : run_->begin);
  }

 private:
  std::vector<Run>::const_iterator run_;
  std::vector<Run>::const_iterator end_;
};

/// One of four cones around the access point: rays that advance along one axis at least as fast as
/// across it. Rows are counted along that axis, columns across it.
class Cone {
 public:
  /// @param along_x  the axis along which the cone opens
  /// @param sign     +1 towards its positive end, -1 towards its negative one
  Cone(const Grid<CellState>& plan, const Position& source_cells, bool along_x, int sign,
       Grid<std::uint8_t>& counts)
      : plan_(plan),
        counts_(counts),
        along_x_(along_x),
        sign_(sign),
        rows_(along_x ? plan.geometry.width() : plan.geometry.height()),
        columns_(along_x ? plan.geometry.height() : plan.geometry.width()),
        source_along_(along_x ? source_cells.x() : source_cells.y()),
        source_across_(along_x ? source_cells.y() : source_cells.x()) {}

  void sweep(bool source_in_wall) {
    constexpr double kSteepest = 1.0;
    const auto source_row = static_cast<std::int64_t>(std::floor(source_along_));
    const std::int64_t nearest = sign_ > 0 ? 0 : rows_ - 1;
    const bool before_grid = sign_ > 0 ? source_row < nearest : source_row > nearest;
    least_slope_ = -kSteepest;
    pieces_.assign(1, {kSteepest, 0, source_in_wall});
    if (source_in_wall) {  // the wall that the rays come from spans them all
      const double everywhere = std::numeric_limits<double>::infinity();
      runs_.assign(1, {-everywhere, everywhere});
    }
    for (std::int64_t row = before_grid ? nearest : source_row; row >= 0 && row < rows_;
         row += sign_) {
      std::swap(runs_, last_runs_);
      findRuns(row);
      const double at = std::max(0.0, distance(row, sign_ > 0 ? 0.0 : 1.0));
      crossInto(at);
      readCounts(row);
      giveUpBeyondGrid(at);
    }
  }

 private:
  Cell cellAt(std::int64_t row, std::int64_t column) const {
    return along_x_ ? Cell{row, column} : Cell{column, row};
  }

  /// How far along the cone a place in a row is; `offset` is 0 at its low border, 1 at its high.
  double distance(std::int64_t row, double offset) const {
    return sign_ * (static_cast<double>(row) + offset - source_along_);
  }

  void findRuns(std::int64_t row) {
    runs_.clear();
    for (std::int64_t column = 0; column < columns_; ++column) {
      if (plan_[cellAt(row, column)] != CellState::kOccupied) {
        continue;
      }
      const auto begin = static_cast<double>(column) - source_across_;
      if (!runs_.empty() && runs_.back().end == begin) {
        runs_.back().end += 1.0;
      } else {
        runs_.push_back({begin, begin + 1.0});
      }
    }
  }

  /// All rays cross from the last row into the next at a distance.
  ///
  /// A ray is in at most two cells of a row: the one where it came in, and the one where it goes
  /// out here. Coming from the open into a wall, in either step, counts one more.
  void crossInto(double at) {
    next_.clear();
    RunCursor last(last_runs_);
    RunCursor next(runs_);
    double position = least_slope_ * at;
    for (const Piece& piece : pieces_) {
      const double piece_end = piece.end_slope * at;
      bool done = false;
      while (!done) {
        const bool goes_out_in_wall = last.isWall(position);
        const bool comes_in_in_wall = next.isWall(position);
        const int entered = (goes_out_in_wall && !piece.in_wall ? 1 : 0) +
                            (comes_in_in_wall && !goes_out_in_wall ? 1 : 0);
        const double change =
            std::min(last.change(goes_out_in_wall), next.change(comes_in_in_wall));
        done = !(change < piece_end);
        position = done ? piece_end : change;
        append(done ? piece.end_slope : change / at, piece.walls + entered, comes_in_in_wall);
      }
    }
    std::swap(pieces_, next_);
  }

  void append(double end_slope, int walls, bool in_wall) {
    if (!next_.empty() && next_.back().walls == walls && next_.back().in_wall == in_wall) {
      next_.back().end_slope = end_slope;
    } else {
      next_.push_back({end_slope, walls, in_wall});
    }
  }

  /// The centre of a cell of this cone lies on a ray that came into the row in that cell.
  void readCounts(std::int64_t row) {
    const double at = distance(row, 0.5);
    if (at <= 0.0) {
      return;  // behind the access point, in its own row
    }
    const auto first = static_cast<std::int64_t>(std::ceil(source_across_ - at - 0.5));
    const auto last = static_cast<std::int64_t>(std::floor(source_across_ + at - 0.5));
    auto piece = pieces_.begin();
    for (std::int64_t column = std::max<std::int64_t>(first, 0);
         column <= std::min(last, columns_ - 1); ++column) {
      const double slope = (static_cast<double>(column) + 0.5 - source_across_) / at;
      while (piece + 1 != pieces_.end() && piece->end_slope <= slope) {
        ++piece;
      }
      const Cell cell = cellAt(row, column);
      if (plan_[cell] == CellState::kFree) {
        counts_[cell] = static_cast<std::uint8_t>(std::min<int>(piece->walls, kMostWalls));
      }
    }
  }

  /// Drops the rays that have left the grid sideways: they meet none of its cells again.
  void giveUpBeyondGrid(double at) {
    if (at <= 0.0) {
      return;
    }
    const double low = -source_across_ / at;
    const double high = (static_cast<double>(columns_) - source_across_) / at;
    const auto gone = std::find_if(pieces_.begin(), pieces_.end() - 1,
                                   [low](const Piece& piece) { return piece.end_slope > low; });
    if (gone != pieces_.begin()) {
      least_slope_ = (gone - 1)->end_slope;
      pieces_.erase(pieces_.begin(), gone);
    }
    while (pieces_.size() > 1 && pieces_[pieces_.size() - 2].end_slope > high) {
      pieces_.pop_back();
    }
  }

  const Grid<CellState>& plan_;
  Grid<std::uint8_t>& counts_;
  const bool along_x_;
  const int sign_;
  const std::int64_t rows_;
  const std::int64_t columns_;
  const double source_along_;
  const double source_across_;
  double least_slope_ = 0.0;  // where the first piece begins
  std::vector<Piece> pieces_;
  std::vector<Piece> next_;
  std::vector<Run> runs_;
  std::vector<Run> last_runs_;
};

bool isCounted(std::uint8_t value) { return value <= kMostWalls; }

/// Follows one ray away from the access point.
void followRay(const Grid<std::uint8_t>& k_map, const Ray& ray, bool walls_are_marked,
               std::vector<Cell>& between, Grid<CellState>& plan) {
  int last_count = kNoCount;
  between.clear();
  ray.forEachCell([&](Cell cell) {
    if (!k_map.geometry.contains(cell)) {
      return;
    }
    if (!isCounted(k_map[cell])) {
      if (!walls_are_marked || k_map[cell] == kWallCell) {
        between.push_back(cell);
      }
      return;
    }
    if (k_map[cell] == last_count + 1) {
      for (const Cell wall : between) {
        plan[wall] = CellState::kOccupied;
      }
    }
    last_count = k_map[cell];
    between.clear();
  });
}

}  // namespace

Grid<std::uint8_t> forwardKVisibility(const Grid<CellState>& plan, const Position& access_point) {
  const GridGeometry& geometry = plan.geometry;
  Grid<std::uint8_t> counts(geometry, kNoCount);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (plan.cells[i] == CellState::kOccupied) {
      counts.cells[i] = kWallCell;
    }
  }
  const Position source = geometry.toCells(access_point);
  const Cell source_cell = geometry.cellAt(access_point);
  const bool inside = geometry.contains(source_cell);
  const bool in_wall = inside && plan[source_cell] == CellState::kOccupied;
  for (const bool along_x : {true, false}) {
    for (const int sign : {1, -1}) {
      Cone(plan, source, along_x, sign, counts).sweep(in_wall);
    }
  }
  if (inside && plan[source_cell] == CellState::kFree) {
    counts[source_cell] = 0;
  }
  return counts;
}

Grid<CellState> denseInverseKVisibility(const Grid<std::uint8_t>& k_map,
                                        const Position& access_point) {
  const GridGeometry& geometry = k_map.geometry;
  Grid<CellState> plan(geometry, CellState::kUnknown);
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    plan.cells[i] = isCounted(k_map.cells[i]) ? CellState::kFree : CellState::kUnknown;
  }
  const bool walls_are_marked =
      std::find(k_map.cells.begin(), k_map.cells.end(), kWallCell) != k_map.cells.end();
  std::vector<Cell> between;
  const auto follow = [&](double x, double y) {
    const Position end = geometry.origin() + geometry.resolution() * Position(x, y);
    followRay(k_map, Ray(geometry, access_point, end), walls_are_marked, between, plan);
  };
  // Sixteen rays for each cell of the rim, so that hardly a wall cell is passed on both sides:
  // eight still miss up to 2 % in a large plan, sixteen less than 0.5 %.
  const auto width = static_cast<double>(geometry.width());
  const auto height = static_cast<double>(geometry.height());
  for (double x = 0.03125; x < width; x += 0.0625) {
    follow(x, 0.5);
    follow(x, height - 0.5);
  }
  for (double y = 0.03125; y < height; y += 0.0625) {
    follow(0.5, y);
    follow(width - 0.5, y);
  }
  return plan;
}

}  // namespace sfw
