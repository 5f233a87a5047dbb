#include "evaluation/evaluation_truth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "evaluation/samples.h"
#include "grid/distance_transform.h"
#include "grid/morphology.h"
#include "grid/ray.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kMaxGap = 1.0;            // [m] positions farther apart are not joined
constexpr double kClosingRadius = 1.2;     // [m]
constexpr double kGrowth = 0.15;           // [m]
constexpr double kWallReach = 2.0;         // [cells] from the free region to its walls
constexpr double kMaxLatticeCells = 64e6;  // 400 m x 400 m; takes a few GB

/// Counts the whole cells within the truth. In double arithmetic, 43 x 0.05 / 0.05 gives only 42.
GridGeometry latticeOf(const GridGeometry& truth) {
  const auto cells = [&](std::int64_t side) {
    return std::floor(static_cast<double>(side) * truth.resolution() / kEvaluationResolutionM);
  };
  const double width = cells(truth.width());
  const double height = cells(truth.height());
  if (!(width >= 1.0 && height >= 1.0 && width * height <= kMaxLatticeCells)) {
    throw InputError("the truth must cover between 0.05 m x 0.05 m and 160000 m2");
  }
  return {kEvaluationResolutionM, truth.origin(), static_cast<std::int64_t>(width),
          static_cast<std::int64_t>(height)};
}

std::vector<Position> withoutRepeats(std::vector<Position> path) {
  path.erase(std::unique(path.begin(), path.end()), path.end());
  return path;
}

/// The component of free cells that contains most positions of the path.
Mask regionOf(const Mask& free, const std::vector<Position>& path) {
  const Components components = labelComponents(free);
  std::vector<std::size_t> positions_on(static_cast<std::size_t>(components.count) + 1, 0);
  for (const Position& position : path) {
    const Cell c = free.geometry.cellAt(position);
    if (free.geometry.contains(c)) {
      ++positions_on[static_cast<std::size_t>(components.label[c])];
    }
  }
  positions_on[0] = 0;  // not a component
  const auto most = std::max_element(positions_on.begin(), positions_on.end());
  if (*most == 0) {
    throw InputError(
        "no position of the path lies in free space of the truth: check that both are in the "
        "same frame");
  }
  Mask region(free.geometry);
  const std::int64_t label = most - positions_on.begin();
  for (std::size_t i = 0; i < region.cells.size(); ++i) {
    region.cells[i] = components.label.cells[i] == label ? 1 : 0;
  }
  return region;
}

/// Marks the cells between two cells: the nearest to the line at each step along its longer side.
void drawLine(Cell from, Cell to, Mask& mask) {
  const std::int64_t steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  for (std::int64_t i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0.0 : static_cast<double>(i) / static_cast<double>(steps);
    const auto between = [t](std::int64_t a, std::int64_t b) {
      return static_cast<std::int64_t>(
          std::nearbyint(static_cast<double>(a) + static_cast<double>(b - a) * t));
    };
    mask[{between(from.x, to.x), between(from.y, to.y)}] = 1;
  }
}

/// Positions outside the lattice are drawn on its border, so that a path along the border stays
/// connected.
Mask drawPath(const GridGeometry& lattice, const std::vector<Position>& path) {
  Mask mask(lattice);
  std::optional<Cell> last;
  for (const Position& position : path) {
    const Cell outer = lattice.cellAt(position);
    const Cell c{std::clamp<std::int64_t>(outer.x, 0, lattice.width() - 1),
                 std::clamp<std::int64_t>(outer.y, 0, lattice.height() - 1)};
    const Cell from = last.value_or(c);
    const double gap =
        std::hypot(static_cast<double>(c.x - from.x), static_cast<double>(c.y - from.y));
    drawLine(gap < kMaxGap / lattice.resolution() ? from : c, c, mask);
    last = c;
  }
  return mask;
}

Mask drawRays(const GridGeometry& lattice, const std::vector<Position>& path,
              const std::vector<Position>& access_points) {
  // Ray is exact only to this distance from the grid, and no signal reaches 10 km.
  const Position reach(1e4, 1e4);
  const Box near(lattice.box().min() - reach, lattice.box().max() + reach);
  Mask mask(lattice);
  for (const Position& access_point : access_points) {
    for (const Position& position : path) {
      if (!near.contains(access_point) || !near.contains(position)) {
        continue;
      }
      Ray(lattice, access_point, position).forEachCell([&](Cell c) {
        if (lattice.contains(c)) {
          mask[c] = 1;
        }
      });
    }
  }
  return mask;
}

}  // namespace

void requireUsable(const std::vector<Position>& positions, const char* name) {
  constexpr double kFar = 1e6;  // metres
  for (const Position& position : positions) {
    if (!(position.array().abs() <= kFar).all()) {
      throw std::invalid_argument(std::string(name) + " must be finite and below 1000 km");
    }
  }
}

EvaluationTruth makeEvaluationTruth(const Grid<CellState>& truth, const std::vector<Position>& path,
                                    const std::vector<Position>& access_points) {
  if (path.empty()) {
    throw std::invalid_argument("path must not be empty");
  }
  requireUsable(path, "path");
  requireUsable(access_points, "access_points");
  requireUsable({truth.geometry.origin()}, "the truth's origin");
  const std::vector<Position> positions = withoutRepeats(path);
  const GridGeometry lattice = latticeOf(truth.geometry);
  const Grid<CellState> states = sampled(truth, lattice, CellState::kUnknown);

  EvaluationTruth result(lattice);
  result.region = regionOf(cellsOfState(states, CellState::kFree), positions);
  result.occupied = cellsOfState(states, CellState::kOccupied);
  result.known = complement(cellsOfState(states, CellState::kUnknown));
  const Mask bordering = dilated(result.region, kWallReach);
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    result.walls.cells[i] = result.occupied.cells[i] & bordering.cells[i];
  }
  result.path = drawPath(lattice, positions);
  if (!access_points.empty()) {
    result.observed = drawRays(lattice, positions, access_points);
  }
  return result;
}

Mask pathOnlyFree(const Mask& path) {
  const double resolution = path.geometry.resolution();
  const Mask near = closed(path, kClosingRadius / resolution);
  Mask filled(path.geometry);
  for (std::size_t i = 0; i < path.cells.size(); ++i) {
    filled.cells[i] = near.cells[i] | path.cells[i];
  }
  const Grid<double> distance = distanceTransform(withHolesFilled(filled));
  Mask grown(path.geometry);
  for (std::size_t i = 0; i < path.cells.size(); ++i) {
    grown.cells[i] = distance.cells[i] * resolution <= kGrowth ? 1 : 0;
  }
  return grown;
}

}  // namespace sfw
