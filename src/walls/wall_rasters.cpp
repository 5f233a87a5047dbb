#include "walls/wall_rasters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "grid/axis_rasters.h"
#include "grid/cells_at_centres.h"
#include "grid/for_each_cell.h"
#include "grid/ray.h"
#include "walls/grid_lines.h"

namespace sfw {
namespace {

/// Adds one member's losses to each cell of the result. Lattices at an angle have no direction
/// along the axes, so they do not count.
DirectedRasters lossesOf(const LineField& member, const GridGeometry& geometry) {
  DirectedRasters losses{Grid<float>(geometry), Grid<float>(geometry)};
  for (const LatticeLoss& loss : member) {
    if (loss.lattice.yaw_rad != 0.0) {
      continue;
    }
    const CellsAtCentres cells(geometry, loss.lattice.geometry);
    forEachCell(geometry, [&](Cell c) {
      const Cell at = cells[c];
      if (loss.lattice.geometry.contains(at)) {
        losses.along_x[c] += loss.walls_along_x[at];
        losses.along_y[c] += loss.walls_along_y[at];
      }
    });
  }
  return losses;
}

/// Mean over 0.7 m across a wall and 0.5 m along it.
DirectedRasters around(const DirectedRasters& losses) {
  const double resolution = losses.along_x.geometry.resolution();
  const std::int64_t across = std::lround(0.3 / resolution);
  const std::int64_t along = std::lround(0.2 / resolution);
  return {rowMean(columnMean(losses.along_x, across), along),
          columnMean(rowMean(losses.along_y, across), along)};
}

void addTo(Grid<float>& sum, const Grid<float>& values, float share) {
  for (std::size_t i = 0; i < sum.cells.size(); ++i) {
    sum.cells[i] += share * values.cells[i];
  }
}

void addSquaresTo(Grid<float>& sum, const Grid<float>& values, float share) {
  for (std::size_t i = 0; i < sum.cells.size(); ++i) {
    sum.cells[i] += share * values.cells[i] * values.cells[i];
  }
}

/// Turns means of squares into standard deviations.
void toDeviation(const Grid<float>& mean, float scale, Grid<float>& squares) {
  for (std::size_t i = 0; i < squares.cells.size(); ++i) {
    const float variance = squares.cells[i] - mean.cells[i] * mean.cells[i];
    squares.cells[i] = scale * std::sqrt(std::max(0.0F, variance));
  }
}

/// Adds the stretches in the gap between two cells of the footprint. A gap at the border of the
/// grid has such a cell at one end only.
void addGap(const Stretch& gap, bool after_pass, bool before_pass, std::int64_t widest,
            std::int64_t beyond, Stretches& stretches) {
  const std::int64_t width = gap.end - gap.first;
  if (width <= 0) {
    return;
  }
  if (after_pass && before_pass && width <= widest) {
    stretches.between_passes.push_back(gap);
    return;
  }
  const std::int64_t most = after_pass && before_pass ? width / 2 : width;
  const std::int64_t length = std::min(beyond, most);
  if (after_pass) {
    stretches.beyond_passes.push_back({gap.line, gap.first, gap.first + length});
  }
  if (before_pass) {
    stretches.beyond_passes.push_back({gap.line, gap.end - length, gap.end});
  }
}

}  // namespace

DirectedLoss directedLoss(const WallField& walls, const GridGeometry& geometry) {
  const auto empty = [&] { return DirectedRasters{Grid<float>(geometry), Grid<float>(geometry)}; };
  DirectedLoss loss{empty(), empty()};
  const float share = 1.0F / static_cast<float>(std::max<std::size_t>(walls.members.size(), 1));
  for (const LineField& member : walls.members) {
    const DirectedRasters losses = lossesOf(member, geometry);
    const DirectedRasters sums = around(losses);
    addTo(loss.mean.along_x, losses.along_x, share);
    addTo(loss.mean.along_y, losses.along_y, share);
    addSquaresTo(loss.spread.along_x, sums.along_x, share);
    addSquaresTo(loss.spread.along_y, sums.along_y, share);
  }
  const DirectedRasters mean = around(loss.mean);
  constexpr float kLatticeCells = 3.5F;  // of 0.2 m in 0.7 m
  toDeviation(mean.along_x, kLatticeCells, loss.spread.along_x);
  toDeviation(mean.along_y, kLatticeCells, loss.spread.along_y);
  return loss;
}

DirectedRasters rayDirections(const GridGeometry& geometry,
                              const std::vector<AccessPointBins>& access_points) {
  DirectedRasters rays{Grid<float>(geometry), Grid<float>(geometry)};
  for (const AccessPointBins& one : access_points) {
    for (const RadioBin& bin : one.bins) {
      const Position direction = (bin.position - one.position).normalized().cwiseAbs();
      Ray(geometry, one.position, bin.position).forEachCell([&](Cell c) {
        if (geometry.contains(c)) {
          rays.along_x[c] += static_cast<float>(direction.x());
          rays.along_y[c] += static_cast<float>(direction.y());
        }
      });
    }
  }
  return rays;
}

DirectedRasters headings(const DrivenPath& path) {
  const GridGeometry& geometry = path.cells.geometry;
  DirectedRasters squares{Grid<float>(geometry), Grid<float>(geometry)};
  for (std::size_t i = 1; i < path.driven.size(); ++i) {
    const Position step = path.driven[i] - path.driven[i - 1];
    constexpr double kStanding = 1e-6;  // [m]
    if (step.norm() > path.max_gap_m || step.norm() < kStanding) {
      continue;
    }
    Ray(geometry, path.driven[i - 1], path.driven[i]).forEachCell([&](Cell c) {
      if (geometry.contains(c)) {
        squares.along_x[c] += static_cast<float>(step.x() * step.x());
        squares.along_y[c] += static_cast<float>(step.y() * step.y());
      }
    });
  }
  for (std::size_t i = 0; i < geometry.size(); ++i) {
    const float sum = squares.along_x.cells[i] + squares.along_y.cells[i];
    if (sum > 0.0F) {
      squares.along_x.cells[i] /= sum;
      squares.along_y.cells[i] /= sum;
    }
  }
  return squares;
}

Stretches stretchesBeside(const Mask& footprint, const GridLines& lines, std::int64_t widest,
                          std::int64_t beyond) {
  Stretches stretches;
  for (std::int64_t line = 0; line < lines.count(); ++line) {
    std::int64_t last = -1;  // place of the footprint
    for (std::int64_t at = 0; at < lines.length(); ++at) {
      if (footprint[lines.cell(line, at)] != 0) {
        addGap({line, last + 1, at}, last >= 0, true, widest, beyond, stretches);
        last = at;
      }
    }
    addGap({line, last + 1, lines.length()}, last >= 0, false, widest, beyond, stretches);
  }
  return stretches;
}

StripSums stripSums(const Grid<float>& values, const GridLines& lines,
                    const std::vector<Stretch>& stretches, std::int64_t reach) {
  const GridGeometry& geometry = values.geometry;
  Grid<float> sums(geometry);
  StripSums result{Grid<float>(geometry), Mask(geometry)};
  for (const Stretch& stretch : stretches) {
    float sum = 0.0F;
    for (std::int64_t at = stretch.first; at < stretch.end; ++at) {
      sum += values[lines.cell(stretch.line, at)];
    }
    for (std::int64_t at = stretch.first; at < stretch.end; ++at) {
      sums[lines.cell(stretch.line, at)] = sum;
      result.in_strip[lines.cell(stretch.line, at)] = 1;
    }
  }
  for (std::int64_t line = 0; line < lines.count(); ++line) {
    for (std::int64_t at = 0; at < lines.length(); ++at) {
      if (result.in_strip[lines.cell(line, at)] == 0) {
        continue;
      }
      float sum = 0.0F;
      float count = 0.0F;
      const std::int64_t last = std::min(line + reach, lines.count() - 1);
      for (std::int64_t i = std::max<std::int64_t>(line - reach, 0); i <= last; ++i) {
        sum += sums[lines.cell(i, at)];
        count += static_cast<float>(result.in_strip[lines.cell(i, at)]);
      }
      result.sum[lines.cell(line, at)] = sum / count;
    }
  }
  return result;
}

}  // namespace sfw
