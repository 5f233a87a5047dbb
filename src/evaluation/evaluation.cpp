#include "evaluation/evaluation.h"

#include <algorithm>
#include <cmath>

#include "evaluation/area_under_curve.h"
#include "evaluation/evaluation_truth.h"
#include "evaluation/samples.h"
#include "grid/distance_transform.h"
#include "grid/morphology.h"

namespace sfw {
namespace {

constexpr double kTolerance = 0.1;    // [m] of the tolerant free precision
constexpr double kBeyond = 0.3;       // [m] from the path
constexpr double kTwoCells = 2.0;     // tolerance of walls
constexpr double kFourCells = 4.0;    // second tolerance, of walls by the radio alone
constexpr double kMostlyKnown = 0.9;  // share of known cells from which the others are left out
constexpr double kLeastProbability = 0.5 / 255.0;  // half a step of an 8-bit raster

std::size_t count(const Mask& mask) {
  return mask.cells.size() -
         static_cast<std::size_t>(std::count(mask.cells.begin(), mask.cells.end(), 0));
}

Mask both(const Mask& a, const Mask& b) {
  Mask result(a.geometry);
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    result.cells[i] = a.cells[i] != 0 && b.cells[i] != 0 ? 1 : 0;
  }
  return result;
}

/// Share of the set's cells that are also in another; 0 if it is empty.
double share(const Mask& set, const Mask& other) {
  const std::size_t whole = count(set);
  return whole == 0 ? 0.0
                    : static_cast<double>(count(both(set, other))) / static_cast<double>(whole);
}

/// Returns the same as share, but nothing if the set is empty. It is for sets of the truth.
std::optional<double> shareIfAny(const Mask& set, const Mask& other) {
  return count(set) == 0 ? std::nullopt : std::optional(share(set, other));
}

/// The observed walls; nothing without access points.
std::optional<Mask> observedWalls(const EvaluationTruth& truth) {
  return truth.observed ? std::optional(both(truth.walls, *truth.observed)) : std::nullopt;
}

FreeMetrics freeMetrics(const Mask& free, const EvaluationTruth& truth) {
  const double resolution = truth.lattice().resolution();
  const Grid<double> to_region = distanceTransform(truth.region);
  const Grid<double> to_path = distanceTransform(truth.path);
  Mask near_region(truth.lattice());
  Mask far(truth.lattice());
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    near_region.cells[i] = to_region.cells[i] * resolution <= kTolerance ? 1 : 0;
    far.cells[i] = free.cells[i] != 0 && to_path.cells[i] * resolution > kBeyond ? 1 : 0;
  }
  const auto shared = static_cast<double>(count(both(free, truth.region)));
  FreeMetrics metrics;
  metrics.precision = share(free, truth.region);
  metrics.tolerant_precision = share(free, near_region);
  metrics.recall = share(truth.region, free);
  metrics.iou = shared / (static_cast<double>(count(free)) +
                          static_cast<double>(count(truth.region)) - shared);
  metrics.beyond_m2 = static_cast<double>(count(both(far, truth.region))) * resolution * resolution;
  metrics.beyond_precision = share(far, truth.region);
  return metrics;
}

WallMetrics wallMetrics(const Mask& occupied, const EvaluationTruth& truth,
                        double tolerance_cells) {
  const Mask near_called = dilated(occupied, tolerance_cells);
  WallMetrics metrics;
  metrics.precision = share(occupied, dilated(truth.occupied, tolerance_cells));
  metrics.recall = shareIfAny(truth.walls, near_called);
  if (metrics.recall) {
    const double sum = metrics.precision + *metrics.recall;
    metrics.f1 = sum > 0.0 ? 2.0 * metrics.precision * *metrics.recall / sum : 0.0;
  }
  if (const std::optional<Mask> observed = observedWalls(truth)) {
    metrics.observed_recall = shareIfAny(*observed, near_called);
  }
  return metrics;
}

/// Metrics that need nothing but the cells called free.
MapMetrics metricsOfFree(const Mask& called_free, const EvaluationTruth& truth) {
  const auto known = static_cast<double>(count(truth.known));
  const bool mostly_known = known > kMostlyKnown * static_cast<double>(truth.known.cells.size());
  const Mask free = mostly_known ? both(called_free, truth.known) : called_free;
  MapMetrics metrics;
  metrics.free = freeMetrics(free, truth);
  metrics.walls_called_free = shareIfAny(truth.walls, free);
  if (const std::optional<Mask> observed = observedWalls(truth)) {
    metrics.observed_walls_called_free = shareIfAny(*observed, free);
  }
  return metrics;
}

/// Probabilities of the compared cells, by their true state.
Ratings rate(const Grid<float>& probabilities, const Grid<CellState>& map,
             const EvaluationTruth& truth) {
  constexpr float kUndecided = 0.5F;
  const Grid<float> samples = sampled(probabilities, truth.lattice(), kUndecided);
  Ratings rated;
  for (std::size_t i = 0; i < samples.cells.size(); ++i) {
    const float p = samples.cells[i];
    const double valid = p >= 0.0F && p <= 1.0F ? p : kUndecided;
    if (map.cells[i] == CellState::kUnknown) {
      continue;
    }
    if (truth.region.cells[i] != 0) {
      rated.free.push_back(valid);
    } else if (truth.walls.cells[i] != 0) {
      rated.wall.push_back(valid);
    }
  }
  return rated;
}

ProbabilityMetrics probabilityMetrics(const Ratings& rated) {
  ProbabilityMetrics metrics;
  metrics.cells = rated.free.size() + rated.wall.size();
  metrics.auc = areaUnderCurve(rated);
  if (metrics.cells == 0) {
    return metrics;
  }
  double squares = 0.0;
  double losses = 0.0;
  const auto add = [&](double miss) {  // probability of the wrong state
    squares += miss * miss;
    losses -= std::log(1.0 - std::clamp(miss, kLeastProbability, 1.0 - kLeastProbability));
  };
  for (const double p : rated.free) {
    add(p);
  }
  for (const double p : rated.wall) {
    add(1.0 - p);
  }
  metrics.brier = squares / static_cast<double>(metrics.cells);
  metrics.log_loss = losses / static_cast<double>(metrics.cells);
  return metrics;
}

/// The greatest value within some cells along an axis.
Grid<float> greatest(const Grid<float>& values, std::int64_t reach, const Cell& axis) {
  Grid<float> result(values.geometry);
  for (std::size_t i = 0; i < values.cells.size(); ++i) {
    const Cell c = values.geometry.cell(i);
    float most = values.cells[i];
    for (std::int64_t step = -reach; step <= reach; ++step) {
      const Cell near{c.x + step * axis.x, c.y + step * axis.y};
      if (values.geometry.contains(near)) {
        most = std::max(most, values[near]);
      }
    }
    result.cells[i] = most;
  }
  return result;
}

/// The cells that count as walls by the radio alone: high losses on a ridge.
Mask wallsByRadio(const Grid<float>& losses) {
  constexpr float kLeastLoss = 0.6F;   // [dB]
  constexpr float kLeastShare = 0.5F;  // of the greatest around
  constexpr std::int64_t kAround = 4;  // cells, 0.2 m
  const Grid<float> around = greatest(greatest(losses, kAround, {1, 0}), kAround, {0, 1});
  Mask walls(losses.geometry);
  for (std::size_t i = 0; i < walls.cells.size(); ++i) {
    const float loss = losses.cells[i];
    walls.cells[i] = loss >= kLeastLoss && loss >= kLeastShare * around.cells[i] ? 1 : 0;
  }
  return walls;
}

/// F1 of the walls by the radio alone, where the truth is known.
std::optional<double> radioWallF1(const Mask& called, const EvaluationTruth& truth,
                                  double tolerance_cells) {
  const Mask observed = both(truth.walls, *truth.observed);
  const std::optional<double> recall = shareIfAny(observed, dilated(called, tolerance_cells));
  if (!recall) {
    return std::nullopt;
  }
  const double precision = share(called, dilated(observed, tolerance_cells));
  const double sum = precision + *recall;
  return sum > 0.0 ? 2.0 * precision * *recall / sum : 0.0;
}

RadioMetrics radioMetrics(const Grid<float>& wall_loss, const EvaluationTruth& truth) {
  const Grid<float> losses = sampled(wall_loss, truth.lattice(), 0.0F);
  const Grid<double> from_path = distanceTransform(truth.path);
  Ratings all;
  Ratings off_path;
  for (std::size_t i = 0; i < losses.cells.size(); ++i) {
    const bool wall = truth.walls.cells[i] != 0;
    if (truth.observed->cells[i] == 0 || (!wall && truth.region.cells[i] == 0)) {
      continue;
    }
    const auto loss = static_cast<double>(losses.cells[i]);
    (wall ? all.wall : all.free).push_back(loss);
    if (from_path.cells[i] * kEvaluationResolutionM > kBeyond) {
      (wall ? off_path.wall : off_path.free).push_back(loss);
    }
  }
  Mask called = wallsByRadio(losses);
  for (std::size_t i = 0; i < called.cells.size(); ++i) {
    if (truth.walls.cells[i] == 0 && truth.region.cells[i] == 0) {
      called.cells[i] = 0;  // nothing to compare with
    }
  }
  return {areaUnderCurve(all), areaUnderCurve(off_path), radioWallF1(called, truth, kTwoCells),
          radioWallF1(called, truth, kFourCells)};
}

MapMetrics metricsOfMap(const EvaluationInput& input, const EvaluationTruth& truth) {
  const Grid<CellState> map = sampled(input.map, truth.lattice(), CellState::kUnknown);
  const Mask occupied = cellsOfState(map, CellState::kOccupied);
  MapMetrics metrics = metricsOfFree(cellsOfState(map, CellState::kFree), truth);
  metrics.wall_one_cell = wallMetrics(occupied, truth, 1.0);
  metrics.wall_two_cells = wallMetrics(occupied, truth, kTwoCells);
  const Mask off_walls = complement(dilated(truth.occupied, kTwoCells));
  metrics.wall_in_free = share(occupied, both(truth.region, off_walls));
  if (input.probabilities) {
    metrics.probability = probabilityMetrics(rate(*input.probabilities, map, truth));
  }
  if (input.navigation) {
    metrics.navigation = input.navigation->metricsOf(input.map, input.probabilities);
  }
  if (input.wall_loss_db && truth.observed) {
    metrics.radio = radioMetrics(*input.wall_loss_db, truth);
  }
  return metrics;
}

Grid<CellState> freeOrUnknown(const Mask& free) {
  Grid<CellState> map(free.geometry, CellState::kUnknown);
  for (std::size_t i = 0; i < free.cells.size(); ++i) {
    map.cells[i] = free.cells[i] != 0 ? CellState::kFree : CellState::kUnknown;
  }
  return map;
}

}  // namespace

Evaluation evaluate(const EvaluationInput& input) {
  const EvaluationTruth truth = makeEvaluationTruth(input.truth, input.path, input.access_points);
  Evaluation evaluation;
  evaluation.map = metricsOfMap(input, truth);
  const Mask path_only = pathOnlyFree(truth.path);
  evaluation.path_only = metricsOfFree(path_only, truth);
  if (input.navigation) {
    evaluation.path_only.navigation =
        input.navigation->metricsOf(freeOrUnknown(path_only), std::nullopt);
  }
  evaluation.free_m2 =
      static_cast<double>(count(truth.region)) * kEvaluationResolutionM * kEvaluationResolutionM;
  evaluation.wall_cells = count(truth.walls);
  if (const std::optional<Mask> observed = observedWalls(truth)) {
    evaluation.observed_wall_cells = count(*observed);
  }
  return evaluation;
}

Grid<CellState> pathOnlyMap(const EvaluationInput& input) {
  return freeOrUnknown(pathOnlyFree(makeEvaluationTruth(input.truth, input.path, {}).path));
}

}  // namespace sfw
