#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"

namespace sfw {

/// From a cell's centre to a straight drive between two others [cells].
double distanceToDrive(Cell c, Cell from, Cell to);

/// Where the centre of a round robot may be. All lengths are in cells, places are centres of cells.
///
/// Free means the same as to requireFree (simulation.h): no cell that is not free, and nothing
/// outside the grid, has its centre within the robot's radius plus half a cell's diagonal.
class ConfigurationSpace {
 public:
  /// @param radius_m positive
  ConfigurationSpace(const Grid<CellState>& plan, double radius_m);

  const GridGeometry& geometry() const { return clearance_.geometry; }

  /// Distance that the robot must keep from the centres of cells that are not free.
  double reach() const { return reach_; }

  /// Distance to the nearest centre of a cell that is not free.
  double clearance(Cell c) const { return clearance_[c]; }

  /// Whether the robot can get to a cell; all cells where it can stand, until keepConnectedTo.
  bool contains(Cell c) const { return geometry().contains(c) && within_[c] != 0; }
  const Mask& cells() const { return within_; }

  /// Leaves only what the robot can reach from a cell that the space contains.
  void keepConnectedTo(Cell start);

  /// The cell with the greatest clearance in the largest connected part, the first in row-major
  /// order of several; nothing if the space is empty.
  std::optional<Cell> middle() const;

  /// Whether a straight drive between two places keeps a distance of `least` from everything.
  /// Exact. O(cells crossed), more where it is a near thing.
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
      // A diagonal step passes between two cells: free for the robot if both of them are.
      if (next != c && contains(next) && contains({c.x, next.y}) && contains({next.x, c.y})) {
        visit(next, x != 0 && y != 0 ? kDiagonal : 1.0);
      }
    }
  }
}

/// Shortest drives over the cells of a space. Keeps memory for its searches; not thread-safe.
class PathFinder {
 public:
  /// @param comfort  clearance that drives keep where the detour is short [cells]
  PathFinder(const ConfigurationSpace& space, double comfort);

  /// The cells of the cheapest drive to the nearest cell for which `wanted` holds, both ends
  /// included; empty if there is none. Stops as soon as that is found.
  std::vector<Cell> toNearest(Cell from, const std::function<bool(Cell)>& wanted);

 private:
  double costOfStep(Cell from, Cell to, double length) const;

  const ConfigurationSpace& space_;
  double comfort_;
  Grid<double> cost_;
  Grid<Cell> before_;
  std::vector<Cell> touched_;
};

/// Lengths of the shortest drives from a growing set of places.
class DriveDistance {
 public:
  explicit DriveDistance(const ConfigurationSpace& space)
      : space_(space), length_(space.geometry(), std::numeric_limits<double>::infinity()) {}

  void add(const std::vector<Cell>& places);

  /// [cells]; infinity where no drive from any place leads.
  double operator[](Cell c) const { return length_[c]; }

 private:
  const ConfigurationSpace& space_;
  Grid<double> length_;
};

}  // namespace sfw
