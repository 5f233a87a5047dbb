#pragma once

#include <cstdint>
#include <vector>

#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// Counts the walls on the rays from an access point to all cells of one of four cones around it.
///
/// The rays of a cone advance along one axis at least as fast as across it. Rows are counted along
/// that axis, columns across it. From row to row the sweep carries the wall count as a piecewise
/// constant function of the ray's slope. Lengths are whole sub-cells, as in Ray, and slopes are
/// fractions. Nothing is rounded, so each count equals that of a walk along Ray, lattice corners
/// included.
class ConeSweep {
 public:
  /// Largest distance of an access point from the grid's origin: the range of Ray [cells].
  static constexpr std::int64_t kFarthest = std::int64_t{1} << 19;

  /// @param source_x,source_y  the access point [sub-cells], inside a cell as Ray snaps it
  /// @param along_x            the axis along which the cone opens
  /// @param sign               +1 towards its positive end, -1 towards its negative one
  ConeSweep(const Grid<CellState>& plan, std::int64_t source_x, std::int64_t source_y, bool along_x,
            int sign);

  /// Writes the counts of the cone's free cells.
  void writeTo(Grid<std::uint8_t>& counts);

 private:
  /// Walls that a ray has entered: twice their number, plus one while it is in a wall.
  using WallCount = std::uint32_t;

  /// Rays of neighbouring slopes with equal counts, and the ray at their end. That ray may pass a
  /// corner and have another count; its slope is across / along.
  struct Piece {
    std::int32_t across;
    std::int32_t along;
    WallCount count;
    WallCount count_at_end;
  };

  /// Positions where walls begin and end in a row, in turns, then one that is never reached.
  using Borders = std::vector<std::int64_t>;

  struct BorderCursor;
  struct Crossing;

  std::size_t index(std::int64_t row, std::int64_t column) const {
    return static_cast<std::size_t>(row * row_stride_ + column * column_stride_);
  }
  std::int64_t distance(std::int64_t row, std::int64_t offset) const;
  bool isInWall(std::int64_t row, std::int64_t column) const;

  void findBorders(std::int64_t row);
  void crossInto(std::int64_t at);
  void append(std::int64_t across, std::int64_t along, WallCount count, WallCount count_at_end);
  void readCounts(std::int64_t row, Grid<std::uint8_t>& counts) const;
  void dropRaysOutsideGrid(std::int64_t at);

  const Grid<CellState>& plan_;
  const int sign_;
  const std::int64_t rows_;
  const std::int64_t columns_;
  const std::int64_t row_stride_;
  const std::int64_t column_stride_;
  const std::int64_t source_along_;
  const std::int64_t source_across_;
  std::vector<Piece> pieces_;  // the first is only the ray where the next begins
  std::vector<Piece> next_;
  std::size_t next_count_ = 0;
  Borders last_borders_;
  Borders borders_;
};

}  // namespace sfw
