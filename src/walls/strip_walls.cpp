#include "walls/strip_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/median.h"
#include "grid/axis_rasters.h"
#include "grid/morphology.h"
#include "walls/grid_lines.h"
#include "walls/wall_rasters.h"

namespace sfw {
namespace {

/// Evidence counts together over this length along a wall, to both sides [m].
constexpr double kSumReachM = 0.2;
constexpr double kPlaceReachM = 0.3;

/// A wall may move sideways by this many cells from line to line, and pays for each in log odds.
constexpr std::int64_t kLargestJump = 3;
constexpr float kJumpPenalty = 1.0F;

/// Keeps the logarithm of a density finite.
constexpr float kLeastDensity = 1e-3F;

/// The places of a wall on successive lines.
struct Trace {
  std::int64_t first_line = 0;
  std::vector<std::int64_t> places;
};

std::int64_t inCells(double length_m, const GridGeometry& geometry) {
  return std::lround(length_m / geometry.resolution());
}

/// Searches strips of one kind along the rows of a grid, or along its columns.
class StripSearch {
 public:
  /// @param place  density, smoothed along walls
  StripSearch(const Mask& footprint, const Grid<float>& density, const Grid<float>& place,
              const StripWallConfig& config, const GridLines& lines, std::vector<Stretch> stretches)
      : config_(config),
        lines_(lines),
        footprint_(footprint),
        stretches_(std::move(stretches)),
        strips_(stripSums(density, lines, stretches_, inCells(kSumReachM))),
        place_(place) {}

  /// The cells of all strips whose expected number of walls passes a test.
  template <typename Test>
  Mask stripsWhere(Test test) const {
    Mask result(footprint_.geometry);
    for (const Stretch& stretch : stretches_) {
      if (test(expected(stretch))) {
        for (std::int64_t at = stretch.first; at < stretch.end; ++at) {
          result[lines_.cell(stretch.line, at)] = 1;
        }
      }
    }
    return result;
  }

  /// The strips with enough expected walls.
  Mask closed() const {
    return stripsWhere([&](float sum) { return sum > config_.least_expected; });
  }

  /// Finds the walls in closed strips.
  /// @param allowed  cells in which walls may stand
  std::vector<StripWall> find(const Mask& allowed) const {
    Mask searched = closed();
    for (std::size_t i = 0; i < searched.cells.size(); ++i) {
      searched.cells[i] &= allowed.cells[i];
    }
    const Components parts = labelComponents(searched);
    std::vector<std::pair<std::int64_t, std::int64_t>> extents(
        static_cast<std::size_t>(parts.count) + 1, {std::numeric_limits<std::int64_t>::max(), -1});
    for (std::int64_t line = 0; line < lines_.count(); ++line) {
      for (std::int64_t at = 0; at < lines_.length(); ++at) {
        auto& [first, last] = extents[static_cast<std::size_t>(parts.label[lines_.cell(line, at)])];
        first = std::min(first, line);
        last = std::max(last, line);
      }
    }
    std::vector<StripWall> walls;
    for (std::int64_t part = 1; part <= parts.count; ++part) {
      const auto [first, last] = extents[static_cast<std::size_t>(part)];
      if (last - first + 1 >= inCells(config_.shortest_m)) {
        walls.push_back(toWall(likeliest(parts, part, first, last), parts, part));
      }
    }
    return walls;
  }

  /// Lets both ends of a wall grow straight on, each if it meets a barrier in time.
  void extend(const Mask& free, const Mask& walls, StripWall& wall) const {
    const Cell forward = lines_.cell(1, 0);
    std::vector<Cell> before = extension(wall.cells.front(), {-forward.x, -forward.y}, free, walls);
    const std::vector<Cell> after = extension(wall.cells.back(), forward, free, walls);
    std::reverse(before.begin(), before.end());
    wall.cells.insert(wall.cells.begin(), before.begin(), before.end());
    wall.cells.insert(wall.cells.end(), after.begin(), after.end());
  }

 private:
  std::int64_t inCells(double length_m) const {
    return sfw::inCells(length_m, footprint_.geometry);
  }

  /// The expected walls across a stretch: the median, because its cells have different neighbours
  /// along the wall.
  float expected(const Stretch& stretch) const {
    std::vector<float> sums;
    for (std::int64_t at = stretch.first; at < stretch.end; ++at) {
      sums.push_back(strips_.sum[lines_.cell(stretch.line, at)]);
    }
    return median(std::move(sums));
  }

  /// The likeliest trace of a wall through all lines of a part (Viterbi's algorithm).
  Trace likeliest(const Components& parts, std::int64_t part, std::int64_t first,
                  std::int64_t last) const {
    const auto length = static_cast<std::size_t>(lines_.length());
    constexpr float kOutside = -1e3F;  // costs more than any way inside
    const auto score = [&](std::int64_t line, std::size_t at) {
      const Cell c = lines_.cell(line, static_cast<std::int64_t>(at));
      return parts.label[c] == part ? std::log(place_[c] + kLeastDensity) : kOutside;
    };
    std::vector<float> best(length);
    std::vector<std::vector<std::int8_t>> jumps;
    for (std::int64_t line = first; line <= last; ++line) {
      std::vector<float> next(length);
      std::vector<std::int8_t> jump(length, 0);
      for (std::size_t at = 0; at < length; ++at) {
        next[at] = score(line, at) + (line == first ? 0.0F : bestBefore(best, at, jump[at]));
      }
      best = std::move(next);
      jumps.push_back(std::move(jump));
    }
    Trace trace{first, {}};
    std::int64_t at = std::max_element(best.begin(), best.end()) - best.begin();
    for (auto jump = jumps.rbegin(); jump != jumps.rend(); ++jump) {
      trace.places.push_back(at);
      at -= (*jump)[static_cast<std::size_t>(at)];
    }
    std::reverse(trace.places.begin(), trace.places.end());
    return trace;
  }

  /// The score of the best trace that reaches a place from the line before, with its jump.
  static float bestBefore(const std::vector<float>& before, std::size_t at, std::int8_t& jump) {
    float best = -std::numeric_limits<float>::infinity();
    for (std::int64_t step = -kLargestJump; step <= kLargestJump; ++step) {
      const std::int64_t from = static_cast<std::int64_t>(at) - step;
      if (from < 0 || from >= static_cast<std::int64_t>(before.size())) {
        continue;
      }
      const float score = before[static_cast<std::size_t>(from)] -
                          kJumpPenalty * static_cast<float>(std::abs(step));
      if (score > best) {
        best = score;
        jump = static_cast<std::int8_t>(step);
      }
    }
    return best;
  }

  /// The cells of a trace in its part of the strips, jumps included.
  StripWall toWall(const Trace& trace, const Components& parts, std::int64_t part) const {
    StripWall wall;
    std::int64_t last = trace.places.front();
    for (std::size_t i = 0; i < trace.places.size(); ++i) {
      const std::int64_t line = trace.first_line + static_cast<std::int64_t>(i);
      const std::int64_t place = trace.places[i];
      const std::int64_t step = place < last ? -1 : 1;
      for (std::int64_t at = last; at != place + step; at += step) {
        const Cell c = lines_.cell(line, at);
        if (parts.label[c] == part) {
          wall.cells.push_back(c);
        }
      }
      wall.expected += strips_.sum[lines_.cell(line, place)];
      last = place;
    }
    wall.expected /= static_cast<double>(trace.places.size());
    return wall;
  }

  /// The free cells from the end of a wall to the next barrier; none if it is too far, or if the
  /// robot went through.
  std::vector<Cell> extension(Cell end, Cell step, const Mask& free, const Mask& walls) const {
    std::vector<Cell> cells;
    for (std::int64_t i = 0; i < inCells(config_.extension_m); ++i) {
      end = {end.x + step.x, end.y + step.y};
      if (!free.geometry.contains(end) || free[end] == 0 || walls[end] != 0) {
        return cells;
      }
      if (footprint_[end] != 0) {
        break;
      }
      cells.push_back(end);
    }
    return {};
  }

  const StripWallConfig& config_;
  GridLines lines_;
  const Mask& footprint_;
  std::vector<Stretch> stretches_;
  StripSums strips_;
  const Grid<float>& place_;
};

/// The searches along one axis.
struct AxisSearch {
  AxisSearch(const Mask& footprint, const Grid<float>& density, const StripWallConfig& config,
             bool rows)
      : lines(footprint.geometry, rows),
        place(rows ? columnMean(density, inCells(kPlaceReachM, footprint.geometry))
                   : rowMean(density, inCells(kPlaceReachM, footprint.geometry))),
        stretches(stretchesBeside(footprint, lines, inCells(config.widest_m, footprint.geometry),
                                  inCells(config.beyond_m, footprint.geometry))),
        between(footprint, density, place, config, lines, stretches.between_passes),
        beyond(footprint, density, place, config, lines, stretches.beyond_passes) {}

  GridLines lines;
  Grid<float> place;
  Stretches stretches;
  StripSearch between;
  StripSearch beyond;
};

/// The cells of strips that are open along one axis and not closed along the other one.
Mask openCells(const StripSearch& rows, const StripSearch& columns, float most_expected) {
  const auto is_open = [&](float sum) { return sum < most_expected; };
  const Mask open_rows = rows.stripsWhere(is_open);
  const Mask open_columns = columns.stripsWhere(is_open);
  const Mask closed_rows = rows.closed();
  const Mask closed_columns = columns.closed();
  Mask open(open_rows.geometry);
  for (std::size_t i = 0; i < open.cells.size(); ++i) {
    const bool is_closed = closed_rows.cells[i] != 0 || closed_columns.cells[i] != 0;
    open.cells[i] = !is_closed && (open_rows.cells[i] != 0 || open_columns.cells[i] != 0) ? 1 : 0;
  }
  return open;
}

Mask cellsOf(const std::vector<StripWall>& walls, const GridGeometry& geometry) {
  Mask cells(geometry);
  for (const StripWall& wall : walls) {
    for (const Cell c : wall.cells) {
      cells[c] = 1;
    }
  }
  return cells;
}

}  // namespace

StripFindings findStripWalls(const Mask& footprint, const Grid<float>& density, const Mask& free,
                             const StripWallConfig& config) {
  const GridGeometry& geometry = footprint.geometry;
  const AxisSearch rows(footprint, density, config, true);
  const AxisSearch columns(footprint, density, config, false);
  const Mask everywhere(geometry, 1);
  const Mask not_free = complement(free);
  struct Search {
    const StripSearch& strips;
    const Mask& allowed;  // walls stand in these cells
    const Mask& growth;   // ends grow through these cells
    bool is_outer;
  };
  const Search searches[] = {{rows.between, everywhere, free, false},
                             {columns.between, everywhere, free, false},
                             {rows.beyond, not_free, not_free, true},
                             {columns.beyond, not_free, not_free, true}};
  StripFindings findings{
      {},
      openCells(rows.between, columns.between, static_cast<float>(config.most_expected_if_open))};
  std::vector<const Search*> found_by;
  for (const Search& search : searches) {
    for (StripWall& wall : search.strips.find(search.allowed)) {
      wall.is_outer = search.is_outer;
      findings.walls.push_back(std::move(wall));
      found_by.push_back(&search);
    }
  }
  const Mask occupied = cellsOf(findings.walls, geometry);
  for (std::size_t i = 0; i < findings.walls.size(); ++i) {
    found_by[i]->strips.extend(found_by[i]->growth, occupied, findings.walls[i]);
  }
  return findings;
}

}  // namespace sfw
