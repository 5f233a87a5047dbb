// Measures the CPU time of forwardKVisibility. A walk along a ray to every cell, in the same run,
// is the reference.
//
// Usage: k_visibility_benchmark [PLAN]...
// It runs on the given plans, and on generated office floors, tiled to 250..2000 cells a side.

#include <algorithm>
#include <filesystem>
#include <functional>
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

void measure(benchmark::State& state, const Grid<CellState>& plan) {
  const std::vector<Position> centres = freeCentres(plan);
  double sweep = 0.0, longest = 0.0, rays = 0.0;
  std::uint64_t place = 0;
  while (state.KeepRunning()) {
    state.PauseTiming();
    const double chance = 1.0 - Random(1, 1, place++).uniform();
    const Position access_point =
        centres[static_cast<std::size_t>(chance * static_cast<double>(centres.size()))] +
        Position(0.0031, 0.0017);
    const auto work = [&] {
      return static_cast<double>(forwardKVisibility(plan, access_point).cells.back());
    };
    state.ResumeTiming();
    const double first = cpuSeconds(work);
    state.PauseTiming();
    const double best = 1e3 * std::min(first, leastCpuSeconds(kRepetitions - 1, work));
    sweep += best / kPlaces;
    longest = std::max(longest, best);
    rays += raysMilliseconds(plan, access_point, centres) / kPlaces;
    state.ResumeTiming();
  }
  const auto cells = static_cast<double>(plan.cells.size());
  state.counters["width"] = static_cast<double>(plan.geometry.width());
  state.counters["height"] = static_cast<double>(plan.geometry.height());
  state.counters["sweep_ms"] = sweep;
  state.counters["slowest_place_ms"] = longest;
  state.counters["ns_per_cell"] = 1e6 * sweep / cells;
  state.counters["rays_ms"] = rays;
  state.counters["rays_per_sweep"] = rays / sweep;
}

/// @param plan  makes the plan when the benchmark runs
void declare(const std::string& name, const std::function<Grid<CellState>()>& plan) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { measure(state, plan()); })
      ->Iterations(kPlaces)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  return sfw::runBenchmarks(count, arguments, [](const std::vector<std::string>& plans) {
    for (const std::int64_t side : {250, 500, 1000, 2000}) {
      sfw::declare("office floors/" + std::to_string(side), [=] { return sfw::tiledOffice(side); });
    }
    for (const std::string& file : plans) {
      sfw::declare(std::filesystem::path(file).filename().string(),
                   [=] { return sfw::toStates(sfw::readFloorPlan(file)); });
    }
  });
}
