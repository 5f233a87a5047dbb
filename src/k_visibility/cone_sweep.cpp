#include "k_visibility/cone_sweep.h"

#include <algorithm>

#include "grid/ray.h"
#include "k_visibility/k_visibility.h"

namespace sfw {
namespace {

constexpr std::int64_t kCell = Ray::kSubcells;
constexpr std::int64_t kNever = std::int64_t{1} << 31;  // beyond every border, yet safe to multiply

constexpr std::uint32_t kInWall = 1;
constexpr std::uint32_t kOneWall = 2;

/// The count after a ray leaves one row through a cell and enters the next row through another one.
/// Each step from the open into a wall adds one wall.
std::uint32_t advance(std::uint32_t count, bool goes_out_in_wall, bool comes_in_in_wall) {
  const bool entered = goes_out_in_wall ? (count & kInWall) == 0 : comes_in_in_wall;
  return (count & ~kInWall) + (entered ? kOneWall : 0) + (comes_in_in_wall ? kInWall : 0);
}

std::int64_t floorOfQuotient(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

/// Walks over a row's borders from low to high positions.
struct ConeSweep::BorderCursor {
  BorderCursor(const Borders& borders, std::int64_t from) : begin(borders.data()), next(begin) {
    while (*next < from) {
      ++next;
    }
  }

  bool isWall() const { return (next - begin) % 2 != 0; }
  void pass(std::int64_t position) { next += *next == position ? 1 : 0; }

  const std::int64_t* begin;
  const std::int64_t* next;
};

/// The walls on both sides of the line between two rows.
struct ConeSweep::Crossing {
  /// The next position at which either side changes.
  std::int64_t change() const { return std::min(*out.next, *in.next); }

  WallCount here(WallCount count) const { return advance(count, out.isWall(), in.isWall()); }

  /// Passes change(), and gives the count of the one ray that goes exactly through it.
  ///
  /// At a lattice corner a ray steps diagonally, away from the access point's column. Two walls
  /// that meet in the corner leave no gap for a ray.
  WallCount through(WallCount count) {
    const std::int64_t corner = change();
    const bool out_below = out.isWall(), in_below = in.isWall();
    out.pass(corner);
    in.pass(corner);
    const bool goes_out = corner > 0 ? out_below : out.isWall();
    const bool comes_in = corner > 0 ? in.isWall() : in_below;
    const bool between = corner > 0 ? out.isWall() && in_below : out_below && in.isWall();
    const WallCount after = advance(count, goes_out, comes_in);
    return after + (between && !goes_out && !comes_in ? kOneWall : 0);
  }

  BorderCursor out;
  BorderCursor in;
};

ConeSweep::ConeSweep(const Grid<CellState>& plan, std::int64_t source_x, std::int64_t source_y,
                     bool along_x, int sign)
    : plan_(plan),
      sign_(sign),
      rows_(along_x ? plan.geometry.width() : plan.geometry.height()),
      columns_(along_x ? plan.geometry.height() : plan.geometry.width()),
      row_stride_(along_x ? 1 : plan.geometry.width()),
      column_stride_(along_x ? plan.geometry.width() : 1),
      source_along_(along_x ? source_x : source_y),
      source_across_(along_x ? source_y : source_x) {}

void ConeSweep::writeTo(Grid<std::uint8_t>& counts) {
  const std::int64_t source_row = floorOfQuotient(source_along_, kCell);
  const std::int64_t nearest = sign_ > 0 ? 0 : rows_ - 1;
  const bool starts_inside = source_row >= 0 && source_row < rows_;
  if (!starts_inside && (source_row < nearest) != (sign_ > 0)) {
    return;  // the grid lies behind the cone
  }
  const bool in_wall =
      starts_inside && isInWall(source_row, floorOfQuotient(source_across_, kCell));
  const WallCount count = in_wall ? kInWall : 0;
  pieces_.assign({{-1, 1, count, count}, {1, 1, count, count}});
  borders_.assign(1, kNever);
  for (std::int64_t row = starts_inside ? source_row : nearest; row >= 0 && row < rows_;
       row += sign_) {
    std::swap(borders_, last_borders_);
    findBorders(row);
    const std::int64_t at = distance(row, sign_ > 0 ? 0 : kCell);
    if (at > 0) {  // otherwise it is the access point's own row
      crossInto(at);
      dropRaysOutsideGrid(at);
    }
    readCounts(row, counts);
  }
}

/// The position of a line in a row along the cone [sub-cells]; `offset` counts from the row's low
/// border.
std::int64_t ConeSweep::distance(std::int64_t row, std::int64_t offset) const {
  return sign_ * (row * kCell + offset - source_along_);
}

bool ConeSweep::isInWall(std::int64_t row, std::int64_t column) const {
  return column >= 0 && column < columns_ &&
         plan_.cells[index(row, column)] == CellState::kOccupied;
}

void ConeSweep::findBorders(std::int64_t row) {
  const std::int64_t reach = distance(row, sign_ > 0 ? kCell : 0);
  const std::int64_t first = floorOfQuotient(source_across_ - reach, kCell) - 1;
  const std::int64_t last = floorOfQuotient(source_across_ + reach, kCell) + 1;
  const CellState* cell = plan_.cells.data() + row * row_stride_;
  borders_.clear();
  bool in_wall = false;
  const std::int64_t end = std::min(last + 1, columns_);
  for (std::int64_t column = std::max<std::int64_t>(first, 0); column < end; ++column) {
    if ((cell[column * column_stride_] == CellState::kOccupied) != in_wall) {
      in_wall = !in_wall;
      borders_.push_back(column * kCell - source_across_);
    }
  }
  if (in_wall) {
    borders_.push_back(end * kCell - source_across_);
  }
  borders_.push_back(kNever);
}

/// All rays cross from the last row into the next at one distance. A ray is in at most two cells of
/// a row: the cell where it enters, and the cell where it leaves.
void ConeSweep::crossInto(std::int64_t at) {
  if (last_borders_.size() == 1 && borders_.size() == 1) {
    return;  // no walls
  }
  next_.resize(pieces_.size() + last_borders_.size() + borders_.size());
  next_count_ = 0;
  Crossing crossing{{last_borders_, -at}, {borders_, -at}};
  for (const Piece& piece : pieces_) {
    const std::int64_t end = piece.across * at;  // times piece.along
    WallCount here = crossing.here(piece.count);
    while (crossing.change() * piece.along < end) {
      const std::int64_t corner = crossing.change();
      append(corner, at, here, crossing.through(piece.count));
      here = crossing.here(piece.count);
    }
    const bool ends_in_corner = crossing.change() * piece.along == end;
    append(
        piece.across, piece.along, here,
        ends_in_corner ? crossing.through(piece.count_at_end) : crossing.here(piece.count_at_end));
  }
  next_.resize(next_count_);
  std::swap(pieces_, next_);
}

/// Appends a piece; pieces of equal counts are joined.
inline void ConeSweep::append(std::int64_t across, std::int64_t along, WallCount count,
                              WallCount count_at_end) {
  const Piece* last = next_count_ > 1 ? &next_[next_count_ - 1] : nullptr;
  const bool joins = last != nullptr && last->count == count && last->count_at_end == count;
  next_count_ += joins ? 0 : 1;
  next_[next_count_ - 1] = {static_cast<std::int32_t>(across), static_cast<std::int32_t>(along),
                            count, count_at_end};
}

/// The centre of a cell of this cone lies on a ray that came into the row in that cell.
void ConeSweep::readCounts(std::int64_t row, Grid<std::uint8_t>& counts) const {
  const std::int64_t at = distance(row, kCell / 2);
  if (at <= 0) {
    return;  // behind the access point, in its own row
  }
  const std::int64_t middle = kCell / 2 - source_across_;  // of column 0
  const std::int64_t first = -floorOfQuotient(at + middle, kCell);
  const std::int64_t last = floorOfQuotient(at - middle, kCell);
  const Piece* piece = pieces_.data();
  std::int64_t end = piece->across * at;  // times piece->along
  for (std::int64_t column = std::max<std::int64_t>(first, 0);
       column <= std::min(last, columns_ - 1); ++column) {
    const std::int64_t across = column * kCell + middle;
    while (end < across * piece->along) {
      ++piece;
      end = piece->across * at;
    }
    const std::size_t cell = index(row, column);
    if (plan_.cells[cell] == CellState::kFree) {
      const WallCount count = end == across * piece->along ? piece->count_at_end : piece->count;
      counts.cells[cell] =
          static_cast<std::uint8_t>(std::min<WallCount>(count / kOneWall, kMostWalls));
    }
  }
}

/// Drops the rays that have left the grid sideways: they never return.
void ConeSweep::dropRaysOutsideGrid(std::int64_t at) {
  const std::int64_t low = -source_across_;
  const std::int64_t high = columns_ * kCell - source_across_;
  const auto ends_beyond = [at](const Piece& piece, std::int64_t position) {
    return piece.across * at >= position * piece.along;
  };
  if (low < 0) {
    auto in_grid = pieces_.begin();
    while (in_grid + 1 != pieces_.end() && !ends_beyond(*in_grid, low)) {
      ++in_grid;
    }
    pieces_.erase(pieces_.begin(), std::max(in_grid - 1, pieces_.begin()));
  }
  while (high > 0 && pieces_.size() > 2 && ends_beyond(pieces_[pieces_.size() - 2], high)) {
    pieces_.pop_back();
  }
}

}  // namespace sfw
