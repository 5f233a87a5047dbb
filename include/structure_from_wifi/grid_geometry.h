#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "structure_from_wifi/export.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Column and row of a cell; row 0 is the lowest y, as in nav_msgs/OccupancyGrid.
struct Cell {
  std::int64_t x = 0;  ///< column
  std::int64_t y = 0;  ///< row

  /// Compares column and row.
  /// @{
  friend bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y; }
  friend bool operator!=(Cell a, Cell b) { return !(a == b); }
  /// @}
};

/// The position, size and resolution of a grid in the map frame. Immutable.
///
/// Cell (0, 0) has its lower left corner at origin(). A point on a cell's lower or left edge
/// belongs to that cell (floor), so the far edges of the grid lie outside it.
class SFW_EXPORT GridGeometry {
 public:
  /// @param resolution_m  edge of a cell [m], finite and positive
  /// @param origin        lower left corner [m], finite
  /// @param width,height  cells, positive
  /// @throw std::invalid_argument naming the parameter.
  GridGeometry(double resolution_m, const Position& origin, std::int64_t width,
               std::int64_t height);

  /// The largest distance of a map's origin from the frame's origin [cells]. Farther out, single
  /// precision, as in MRPT and most consumers, does not distinguish neighbouring cells.
  static constexpr double kFarthestMap = 2097152.0;

  /// The smallest grid around `box` whose edges are whole multiples of `step_m`.
  ///
  /// Steps are rounded to whole cells and counted from the map frame's origin, so the result
  /// depends only on the box, grows rarely, and fits OctoMap's lattice.
  /// @throw std::invalid_argument if an argument is not positive and finite, the box is empty or
  /// not finite, or the grid would have more than `max_cells` cells or pass
  /// kFarthestMap.
  static GridGeometry covering(const Box& box, double resolution_m, double step_m,
                               std::int64_t max_cells);

  /// Whether covering() returns a grid for these arguments, and does not throw.
  static bool canCover(const Box& box, double resolution_m, double step_m, std::int64_t max_cells);

  /// The edge of a cell [m].
  double resolution() const { return resolution_m_; }
  /// The lower left corner of cell (0, 0) in the map frame [m].
  const Position& origin() const { return origin_; }
  /// The number of columns.
  std::int64_t width() const { return width_; }
  /// The number of rows.
  std::int64_t height() const { return height_; }
  /// The number of cells.
  std::size_t size() const { return static_cast<std::size_t>(width_ * height_); }

  /// Whether a cell lies in the grid.
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }

  /// Row-major position of a contained cell.
  std::size_t index(Cell c) const { return static_cast<std::size_t>(c.y * width_ + c.x); }

  /// The cell at a row-major position.
  Cell cell(std::size_t index) const {
    const auto position = static_cast<std::int64_t>(index);
    return {position % width_, position / width_};
  }

  /// The cell that holds a finite point; it may lie outside the grid.
  Cell cellAt(const Position& point) const;

  /// Centre of a cell [m].
  Position centre(Cell c) const;

  /// A finite point in units of cells from the origin.
  Position toCells(const Position& point) const { return (point - origin_) / resolution_m_; }

  /// The rectangle that the grid covers [m].
  Box box() const;

  /// Compares resolution, origin and size, exactly.
  /// @{
  friend bool operator==(const GridGeometry& a, const GridGeometry& b) {
    return a.resolution_m_ == b.resolution_m_ && a.origin_ == b.origin_ && a.width_ == b.width_ &&
           a.height_ == b.height_;
  }
  friend bool operator!=(const GridGeometry& a, const GridGeometry& b) { return !(a == b); }
  /// @}

 private:
  double resolution_m_;
  Position origin_;
  std::int64_t width_;
  std::int64_t height_;
};

/// A value for every cell of a geometry, row-major from the lowest y.
template <class T>
struct Grid {
  /// Gives every cell the same value.
  explicit Grid(const GridGeometry& g, const T& value = T())
      : geometry(g), cells(g.size(), value) {}

  /// The value of a contained cell.
  /// @{
  T& operator[](Cell c) { return cells[geometry.index(c)]; }
  const T& operator[](Cell c) const { return cells[geometry.index(c)]; }
  /// @}

  GridGeometry geometry;  ///< of the cells
  std::vector<T> cells;   ///< geometry.size() values, row-major
};

/// Column and row of a grid's first cell on the lattice through the map frame's origin.
SFW_EXPORT Cell latticeCell(const GridGeometry& geometry);

/// The distance from the map frame's origin that OctoMap's 16-bit keys reach [cells].
constexpr std::int64_t kOctomapReach = 32768;

/// Whether OctoMap can hold a grid: kOctomapReach voxels from the frame's origin each way.
SFW_EXPORT bool octomapReaches(const GridGeometry& geometry);

/// The state of a cell in a map.
enum class CellState : std::uint8_t { kUnknown, kFree, kOccupied };

}  // namespace sfw
