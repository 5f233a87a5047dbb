// Measures the CPU time of forwardKVisibility. A walk along a ray to every cell, in the same run,
// is the reference.
//
// Usage: k_visibility_benchmark [PLAN]...
// It runs on the given plans, and on generated office floors, tiled to 250..2000 cells a side.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "base/random.h"
#include "comparison.h"
#include "grid/for_each_cell.h"
#include "k_visibility/k_visibility.h"
#include "office_floor.h"
#include "simulation/building/floor_plan_io.h"
#include "simulation/building/wall_crossings.h"

namespace sfw {
namespace {

constexpr int kRepetitions = 5;  // the smallest time counts: other processes disturbed the others
constexpr int kPlaces = 5;       // of access points
constexpr std::size_t kRays = 20000;

/// Office floors side by side.
Grid<CellState> tiledOffice(std::int64_t side) {
  const Grid<CellState> tile = toStates(officeFloor(300.0));
  Grid<CellState> plan(GridGeometry(tile.geometry.resolution(), Position::Zero(), side, side));
  forEachCell(plan.geometry, [&](Cell c) {
    plan[c] = tile[{c.x % tile.geometry.width(), c.y % tile.geometry.height()}];
  });
  return plan;
}

std::vector<Position> freeCentres(const Grid<CellState>& plan) {
  std::vector<Position> centres;
  forEachCell(plan.geometry, [&](Cell c) {
    if (plan[c] == CellState::kFree) {
      centres.push_back(plan.geometry.centre(c));
    }
  });
  return centres;
}

/// Measures the walks along one ray to every free cell. It walks an even sample of the rays and
/// scales the time.
double raysMilliseconds(const Grid<CellState>& plan, const Position& access_point,
                        const std::vector<Position>& centres) {
  const std::size_t stride = centres.size() / std::min(centres.size(), kRays);
  const double walked_s = cpuSeconds([&] {
    std::size_t walls = 0;
    for (std::size_t i = 0; i < centres.size(); i += stride) {
      walls += static_cast<std::size_t>(countWalls(plan, access_point, centres[i]));
    }
    return static_cast<double>(walls);
  });
  return 1e3 * walked_s * static_cast<double>(stride);
}

void measure(const std::string& name, const Grid<CellState>& plan) {
  const std::vector<Position> centres = freeCentres(plan);
  double sweep = 0.0, longest = 0.0, rays = 0.0;
  for (std::uint64_t place = 0; place < kPlaces; ++place) {
    const double chance = 1.0 - Random(1, 1, place).uniform();
    const Position access_point =
        centres[static_cast<std::size_t>(chance * static_cast<double>(centres.size()))] +
        Position(0.0031, 0.0017);
    const double best = 1e3 * leastCpuSeconds(kRepetitions, [&] {
                          const auto last = forwardKVisibility(plan, access_point).cells.back();
                          return static_cast<double>(last);
                        });
    sweep += best / kPlaces;
    longest = std::max(longest, best);
    rays += raysMilliseconds(plan, access_point, centres) / kPlaces;
  }
  const auto cells = static_cast<double>(plan.cells.size());
  std::printf("| %s | %lld x %lld | %.2f | %.2f | %.1f | %.0f | %.0f |\n", name.c_str(),
              static_cast<long long>(plan.geometry.width()),
              static_cast<long long>(plan.geometry.height()), sweep, longest, 1e6 * sweep / cells,
              rays, rays / sweep);
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  try {
    std::puts(
        "| plan | cells | sweep [ms] | slowest place [ms] | sweep [ns/cell] | rays [ms] |"
        " rays : sweep |\n|---|---|---|---|---|---|---|");
    for (const std::int64_t side : {250, 500, 1000, 2000}) {
      sfw::measure("office floors", sfw::tiledOffice(side));
    }
    for (int i = 1; i < count; ++i) {
      sfw::measure(std::filesystem::path(arguments[i]).filename().string(),
                   sfw::toStates(sfw::readFloorPlan(arguments[i])));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "k_visibility_benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
