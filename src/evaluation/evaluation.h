#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "evaluation/navigation_evaluation.h"
#include "structure_from_wifi/grid_geometry.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// Edge [m] of the cells on which maps of any resolution are compared.
constexpr double kEvaluationResolutionM = 0.05;

/// Measures how well the cells called free match the truth's free region.
struct FreeMetrics {
  double precision = 0.0;           ///< share of them in the region; 0 if there are none
  double tolerant_precision = 0.0;  ///< share of them within 0.1 m of the region
  double recall = 0.0;              ///< share of the region that is called free
  double iou = 0.0;                 ///< intersection over union with the region
  double beyond_m2 = 0.0;           ///< area in the region and farther than 0.3 m from the path
  double beyond_precision = 0.0;    ///< precision of those farther than 0.3 m from the path
};

/// Measures how well the cells called occupied match the truth's. Two cells match if the distance
/// of their centres is within a tolerance.
struct WallMetrics {
  double precision = 0.0;                 ///< share near any occupied cell; 0 if there are none
  std::optional<double> recall;           ///< share of the walls that are near one
  std::optional<double> f1;               ///< harmonic mean of the two
  std::optional<double> observed_recall;  ///< recall of the observed walls
};

/// Measures how well the probabilities of cells separate walls from free space.
struct ProbabilityMetrics {
  std::optional<double> auc;    ///< chance that a wall is rated above a free cell; ties count half
  std::optional<double> brier;  ///< mean squared error
  std::optional<double> log_loss;  ///< mean [nat]; probabilities end half an 8-bit step from 0, 1
  std::size_t cells = 0;           ///< that were compared
};

/// Measures how well the wall losses of the radio alone separate walls from free space. Only cells
/// that a ray crosses count.
///
/// A cell counts as a wall if its loss is at least 0.6 dB and at least half of the greatest loss
/// within 0.2 m along the axes. These cells are compared with the observed walls.
struct RadioMetrics {
  std::optional<double> auc;                 ///< of the wall loss; ties count half
  std::optional<double> auc_off_path;        ///< the same farther than 0.3 m from the path
  std::optional<double> wall_f1_two_cells;   ///< tolerance 0.1 m
  std::optional<double> wall_f1_four_cells;  ///< tolerance 0.2 m
};

/// All metrics of one map. A metric is absent if the truth or the input does not define it.
struct MapMetrics {
  NavigationMetrics navigation;
  FreeMetrics free;
  std::optional<WallMetrics> wall_one_cell;   ///< tolerance 0.05 m
  std::optional<WallMetrics> wall_two_cells;  ///< tolerance 0.1 m
  std::optional<double> wall_in_free;         ///< share of cells called occupied that lie in the
                                              ///< free region, over 0.1 m from occupied cells
  std::optional<double> walls_called_free;    ///< share of the walls that are called free
  std::optional<double> observed_walls_called_free;  ///< share of the observed walls called free
  std::optional<ProbabilityMetrics> probability;
  std::optional<RadioMetrics> radio;  ///< absent without wall losses or access points
};

/// The metrics of a map, and those of a map made from the path alone.
struct Evaluation {
  MapMetrics map;
  MapMetrics path_only;  ///< only metrics of free cells and of navigation: it has no walls and no
                         ///< probabilities
  double free_m2 = 0.0;  ///< area of the truth's free region
  std::size_t wall_cells = 0;
  std::optional<std::size_t> observed_wall_cells;  ///< absent without access points
};

/// A map, the truth, and the path that the map was made from.
struct EvaluationInput {
  Grid<CellState> map;
  Grid<CellState> truth;
  std::vector<Position> path;                    ///< antenna positions [m] in the order driven
  std::vector<Position> access_points;           ///< [m]; may be empty
  std::optional<Grid<float>> probabilities;      ///< of being occupied; not in [0, 1] counts as 0.5
  std::optional<Grid<float>> wall_loss_db = {};  ///< of each cell, by the radio alone
  /// Of this truth and path; without it, the metrics of navigation are absent.
  std::shared_ptr<const NavigationEvaluation> navigation = {};
};

/// Compares a map with the truth on cells of 0.05 m in the truth's frame.
///
/// Region: the component of the truth's free cells, connected over edges, that contains most
/// positions of the path. Successive equal positions count once. Positions outside the truth do not
/// count. Walls: the truth's occupied cells within 2 cells of the region. A wall cell is observed
/// if the straight line between an access point and a position crosses it.
/// If more than 90 % of the truth's cells are known, cells called free at the other cells are left
/// out. Probabilities are compared over the cells of region and walls that the map does not call
/// unknown.
/// The path-only map is the path (positions less than 1 m apart are joined) closed with a disc of
/// 1.2 m, its holes filled, grown by 0.15 m.
/// Limits are compared in metres in double arithmetic. There, 3 and 6 cells of 0.05 m lie just
/// above 0.15 and 0.3 m.
///
/// @throw std::invalid_argument if the path is empty or a position is not finite and below 1000 km.
/// @throw InputError if the truth is smaller than a cell or too large, or if the path never touches
/// its free space.
/// O(cells of the truth + positions x access points x cells on a ray).
Evaluation evaluate(const EvaluationInput& input);

/// The path-only map of evaluate(): free or unknown. It does not depend on the map of the input.
/// @throw as evaluate()
Grid<CellState> pathOnlyMap(const EvaluationInput& input);

}  // namespace sfw
