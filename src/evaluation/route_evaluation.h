#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "grid/mask.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// What happens to a robot that plans routes on a map. The three shares add up to 1.
struct RouteMetrics {
  double no_plan = 0.0;                 ///< share of the routes that no plan exists for
  double through_walls = 0.0;           ///< share of the routes whose plan crosses a true wall
  double reached = 0.0;                 ///< share of all other routes
  std::optional<double> detour_median;  ///< length of those over the true shortest; absent if none
  std::optional<double> detours_over_1m;  ///< share of those that are over 1 m longer than needed
};

/// A drive from one place to another, as cells of the truth.
struct RouteEnds {
  Cell from;
  Cell to;
};

/// Draws routes between places that a round robot of 0.15 m radius can reach in truth.
///
/// A place is a free cell farther than the radius and a cell from all other cells. Places belong to
/// the largest part of such cells, connected over edges, and lie within 2 m of the path.
/// Starts are spread evenly over the places. From each start, five routes lead to places over 2 m
/// away. All are drawn by a fixed seed.
///
/// @param path  positions [m], finite and below 1000 km
/// @return routes grouped by their start; none if no places lie 2 m apart. Linear in cells.
std::vector<RouteEnds> drawRoutes(const Grid<CellState>& truth, const std::vector<Position>& path,
                                  std::size_t starts);

/// Plans routes on maps and follows the plans in truth.
///
/// A planner enters free cells at least 0.15 m from occupied cells. A cell at a clearance of d
/// costs 1 + 5 exp(-8 (d - 0.15 m)), so plans keep away from obstacles, as those of the package
/// navfn do. An end of a route that the planner may not enter is moved by up to 0.5 m. A plan
/// crosses a wall if it leaves true free space over occupied cells, and no way through true free
/// space to where it returns is less than 1 m longer than the straight line: to scratch the edge of
/// a wall does not count.
class RouteEvaluation {
 public:
  /// @param routes  grouped by their start, so that one search serves all of a start
  /// O(starts x free cells log free cells).
  RouteEvaluation(const Grid<CellState>& truth, std::vector<RouteEnds> routes);

  std::size_t count() const { return routes_.size(); }

  /// Plans every route on a map of any resolution; not with count() == 0. Costs as much as the
  /// constructor.
  RouteMetrics metricsOf(const Grid<CellState>& map) const;

 private:
  enum class Outcome { kNoPlan, kThroughWall, kReached };

  Outcome follow(const std::vector<Cell>& plan) const;
  bool crossesWall(const std::vector<Cell>& way) const;
  bool connectedNearby(Cell from, Cell to) const;

  Mask free_;
  Mask walls_;
  std::vector<RouteEnds> routes_;
  std::vector<double> shortest_;  // true length of each route [cells]; 0: there is none
};

}  // namespace sfw
