#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// A cell's centre [cells], counted from that of cell (0, 0).
inline Position toPosition(Cell c) { return {static_cast<double>(c.x), static_cast<double>(c.y)}; }

/// The distance from a cell's centre to a straight drive between two other cells [cells].
double distanceToDrive(Cell c, Cell from, Cell to);

/// The cells where the centre of a round robot may be. Lengths are in cells, positions are centres
/// of cells.
///
/// Free has the meaning of requireFree (route.h): no cell that is occupied, unknown or outside the
/// grid has its centre within the robot's radius plus half a cell's diagonal.
class ConfigurationSpace {
 public:
  /// @param radius_m positive
  ConfigurationSpace(const Grid<CellState>& plan, double radius_m);

  const GridGeometry& geometry() const { return clearance_.geometry; }

  /// The distance that the robot must keep from the centres of cells that are not free.
  double reach() const { return reach_; }

  /// The distance to the nearest centre of a cell that is not free.
  double clearance(Cell c) const { return clearance_[c]; }

  /// Whether the robot can reach a cell. Before keepConnectedTo: whether the robot fits there.
  bool contains(Cell c) const { return geometry().contains(c) && within_[c] != 0; }
  const Mask& cells() const { return within_; }

  /// Removes the cells that the robot cannot reach from a cell of the space.
  void keepConnectedTo(Cell start);

  /// The cell with the greatest clearance in the largest connected part; of several, the first in
  /// row-major order. Nothing if the space is empty.
  std::optional<Cell> middle() const;

  /// Whether a straight drive between two cells keeps a distance of `least` from every obstacle.
  /// Exact. O(cells crossed), and more where obstacles are at about that distance.
  bool driveable(Cell from, Cell to, double least) const;

  /// Calls `visit(Cell, length)` for each cell that the robot can drive to from `c` in one step.
  template <class Visitor>
  void forEachStep(Cell c, Visitor&& visit) const;

 private:
  bool clearOfCellsNear(Cell c, Cell from, Cell to, double least) const;

  double reach_;
  Grid<double> clearance_;
  Mask within_;
};

template <class Visitor>
void ConfigurationSpace::forEachStep(Cell c, Visitor&& visit) const {
  constexpr double kDiagonal = 1.41421356237309505;
  for (std::int64_t y = -1; y <= 1; ++y) {
    for (std::int64_t x = -1; x <= 1; ++x) {
      const Cell next{c.x + x, c.y + y};
      // A diagonal step passes between two cells. The robot can take it if both cells are free.
      if (next != c && contains(next) && contains({c.x, next.y}) && contains({next.x, c.y})) {
        visit(next, x != 0 && y != 0 ? kDiagonal : 1.0);
      }
    }
  }
}

/// Finds the shortest drives over the cells of a space. It reuses memory between searches. Not
/// thread-safe.
class PathFinder {
 public:
  /// @param comfort  clearance that drives keep where the detour is short [cells]
  PathFinder(const ConfigurationSpace& space, double comfort);

  /// The cells of the cheapest drive to the nearest cell for which `wanted` holds, both ends
  /// included; empty if there is none. The search stops at the first such cell.
  std::vector<Cell> toNearest(Cell from, const std::function<bool(Cell)>& wanted);

 private:
  double costOfStep(Cell from, Cell to, double length) const;

  const ConfigurationSpace& space_;
  double comfort_;
  Grid<double> cost_;
  Grid<Cell> before_;
  std::vector<Cell> touched_;
};

/// The lengths of the shortest drives from a growing set of cells.
class DriveDistance {
 public:
  explicit DriveDistance(const ConfigurationSpace& space)
      : space_(space), length_(space.geometry(), std::numeric_limits<double>::infinity()) {}

  /// Adds cells to the set and lowers the lengths. O(changed cells log changed cells).
  void add(const std::vector<Cell>& places);

  /// The length to a cell [cells]; infinity if no drive leads there.
  double operator[](Cell c) const { return length_[c]; }

 private:
  const ConfigurationSpace& space_;
  Grid<double> length_;
};

}  // namespace sfw
