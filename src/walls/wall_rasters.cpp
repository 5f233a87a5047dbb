#include "walls/wall_rasters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "grid/axis_rasters.h"
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
    for (std::size_t i = 0; i < geometry.size(); ++i) {
      const Cell at = loss.lattice.geometry.cellAt(geometry.centre(geometry.cell(i)));
      if (loss.lattice.geometry.contains(at)) {
        losses.along_x.cells[i] += loss.walls_along_x[at];
        losses.along_y.cells[i] += loss.walls_along_y[at];
      }
    }
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

/// Puts the sum of the values of each stretch on all of its cells.
void sumStretches(const Mask& footprint, const Grid<float>& values, const GridLines& lines,
                  std::int64_t widest, Grid<float>& sums, Mask& in_strip) {
  for (std::int64_t line = 0; line < lines.count(); ++line) {
    std::int64_t last = -1;  // cell of the footprint
    for (std::int64_t at = 0; at < lines.length(); ++at) {
      if (footprint[lines.cell(line, at)] == 0) {
        continue;
      }
      if (last >= 0 && at - last > 1 && at - last - 1 <= widest) {
        float sum = 0.0F;
        for (std::int64_t i = last + 1; i < at; ++i) {
          sum += values[lines.cell(line, i)];
        }
        for (std::int64_t i = last + 1; i < at; ++i) {
          sums[lines.cell(line, i)] = sum;
          in_strip[lines.cell(line, i)] = 1;
        }
      }
      last = at;
    }
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

StripSums stripSums(const Mask& footprint, const Grid<float>& values, bool along_rows,
                    std::int64_t widest, std::int64_t reach) {
  const GridGeometry& geometry = footprint.geometry;
  const GridLines lines(geometry, along_rows);
  Grid<float> sums(geometry);
  StripSums result{Grid<float>(geometry), Mask(geometry)};
  sumStretches(footprint, values, lines, widest, sums, result.in_strip);
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
