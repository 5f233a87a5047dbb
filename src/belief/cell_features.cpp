#include "belief/cell_features.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "belief/ray_evidence.h"
#include "belief/shortest_paths.h"
#include "grid/axis_rasters.h"
#include "grid/distance_transform.h"
#include "grid/morphology.h"
#include "grid/near_squares.h"
#include "radio/path_loss.h"

namespace sfw {
namespace {

using Values = Grid<float>;

/// Depth of each cell inside a set [m], or minus its distance to the set outside. Both are limited,
/// because farther away the depth no longer matters.
Values signedDepth(const Mask& set) {
  constexpr double kDeepest = 1.2;  // [m]
  const double resolution = set.geometry.resolution();
  const double reach = std::ceil(kDeepest / resolution);
  Values depth(set.geometry);
  if (reach > static_cast<double>(kFarthestNear)) {
    const Grid<double> to_outside = distanceTransform(complement(set));
    const Grid<double> to_set = distanceTransform(set);
    for (std::size_t i = 0; i < depth.cells.size(); ++i) {
      depth.cells[i] = static_cast<float>(std::min(resolution * to_outside.cells[i], kDeepest) -
                                          std::min(resolution * to_set.cells[i], kDeepest));
    }
    return depth;
  }
  const auto cells = static_cast<std::int64_t>(reach);
  std::vector<double> limited;  // distance by its square
  for (std::int64_t square = 0; square < (cells + 1) * (cells + 1); ++square) {
    limited.push_back(std::min(resolution * std::sqrt(static_cast<double>(square)), kDeepest));
  }
  const Grid<std::int16_t> to_outside = nearSquares(complement(set), cells);
  const Grid<std::int16_t> to_set = nearSquares(set, cells);
  const auto limitedOf = [&](std::int16_t square) {
    return square == kBeyondReach ? kDeepest : limited[static_cast<std::size_t>(square)];
  };
  for (std::size_t i = 0; i < depth.cells.size(); ++i) {
    depth.cells[i] =
        static_cast<float>(limitedOf(to_outside.cells[i]) - limitedOf(to_set.cells[i]));
  }
  return depth;
}

/// Maps 0 to 0 and values beyond `scale` towards 1.
float saturating(float value, float scale) { return 1.0F - std::exp(-value / scale); }

/// Depths in sets of three sizes.
struct DepthGrids {
  Values small, middle, large;

  CellInputs::Depths at(std::size_t i) const {
    return {small.cells[i], middle.cells[i], large.cells[i]};
  }
};

/// Evaluates every row of the table. The compiler sees the functions, so it can inline them.
template <std::size_t... kRow>
FeatureVector featuresOf(const CellInputs& cell, std::index_sequence<kRow...> /*rows*/) {
  return {kCellFeatureTable[kRow].value(cell)...};
}

/// Computes fields over the whole grid first, and then the features of single cells.
class CellFeatureExtractor {
 public:
  CellFeatureExtractor(const DrivenPath& path, const std::vector<AccessPointBins>& access_points,
                       const WallField& walls, const std::atomic<bool>& stop,
                       const ExplainedVarianceLimits& limits)
      : stop_(stop),
        geometry_(path.cells.geometry),
        access_points_(access_points),
        walls_(walls),
        distance_(distanceTransform(path.cells)),
        footprint_(geometry_),
        disc_depth_(closedDepths(
            path.cells,
            [this](const Mask& set, double size_m) { return closed(set, inCells(size_m)); })),
        square_depth_(closedDepths(path.cells,
                                   [this](const Mask& set, double size_m) {
                                     return closedWithSquare(set, wholeCells(size_m));
                                   })),
        rays_(rayEvidence(geometry_, access_points, walls.ray_loss_db, stop)),
        strength_beside_(boxMean(walls.loss_db, wholeCells(0.2))),
        paths_(shortestPathsFrom(path.cells, distance_, walls.loss_db, stop)),
        alignment_(axisAlignment(geometry_, path.driven, path.max_gap_m)),
        style_(measurePathStyle(path.cells, disc_depth_.middle, path.driven, path.max_gap_m)),
        explained_variance_(explainedVariance(access_points, walls.ray_loss_db)),
        limited_explained_variance_(
            static_cast<float>(std::clamp(explained_variance_, limits.least, limits.most))) {
    Values covered(geometry_);
    for (std::size_t i = 0; i < distance_.cells.size(); ++i) {
      footprint_.cells[i] =
          distance_.cells[i] * geometry_.resolution() <= path.robot_radius_m ? 1 : 0;
      covered.cells[i] = static_cast<float>(footprint_.cells[i]);
    }
    small_coverage_ = boxMean(covered, wholeCells(0.6)).cells;
    large_coverage_ = boxMean(covered, wholeCells(1.5)).cells;
    axis_distances_ = axisDistances(footprint_, kFarthest);
  }

  CellFeatures extract() const {
    CellFeatures features{geometry_, {}, {}, style_, explained_variance_};
    const auto isNear = [&](double distance) {
      return distance * geometry_.resolution() <= kMaxDistanceToPath;
    };
    const auto count = static_cast<std::size_t>(
        std::count_if(distance_.cells.begin(), distance_.cells.end(), isNear));
    features.cells.reserve(count);
    features.values.reserve(count);  // they are large
    for (std::size_t i = 0; i < distance_.cells.size() && !stop_; ++i) {
      if (isNear(distance_.cells[i])) {
        features.cells.push_back(i);
        features.values.push_back(featuresOf(inputs(i), std::make_index_sequence<kCellFeatures>()));
      }
    }
    return features;
  }

 private:
  static constexpr float kFarthest = 3.0F;  // [m], of distances along axes and to access points

  /// Depths in the path closed with three sizes; holes count as enclosed in the larger two.
  /// @param close  (set, size in metres) to the closed set
  template <class Close>
  DepthGrids closedDepths(const Mask& path, Close&& close) const {
    return {depthOf([&] { return close(path, 0.6); }),
            depthOf([&] { return withHolesFilled(close(path, 1.2)); }),
            depthOf([&] { return withHolesFilled(close(path, 2.4)); })};
  }

  /// Depth in a set. The set is not made after a stop.
  template <class MakeSet>
  Values depthOf(MakeSet&& make) const {
    const Mask set = stop_ ? Mask(geometry_) : make();
    return stop_ ? Values(geometry_) : signedDepth(set);
  }

  double inCells(double metres) const { return metres / geometry_.resolution(); }
  std::int64_t wholeCells(double metres) const { return std::lround(inCells(metres)); }

  double nearestAccessPoint(std::size_t i) const {
    double nearest = kFarthest;
    const Position centre = geometry_.centre(geometry_.cell(i));
    for (const AccessPointBins& one : access_points_) {
      nearest = std::min(nearest, (one.position - centre).norm());
    }
    return nearest;
  }

  std::array<float, 4> sortedAxisDistances(std::size_t i) const {
    std::array<std::array<float, 2>, 2> axes{{{axis_distances_[0].cells[i],  //
                                               axis_distances_[1].cells[i]},
                                              {axis_distances_[2].cells[i],  //
                                               axis_distances_[3].cells[i]}}};
    for (auto& axis : axes) {
      std::sort(axis.begin(), axis.end());
    }
    std::sort(axes.begin(), axes.end());
    return {axes[0][0] / kFarthest, axes[0][1] / kFarthest, axes[1][0] / kFarthest,
            axes[1][1] / kFarthest};
  }

  CellInputs inputs(std::size_t i) const {
    const auto distance_m = static_cast<float>(distance_.cells[i] * geometry_.resolution());
    const std::size_t source = paths_.source.cells[i];
    const bool has_rays = rays_.rays.cells[i] > 0.0F;
    CellInputs cell;
    cell.path_distance_m = distance_m;
    cell.disc_depth_m = disc_depth_.at(i);
    cell.square_depth_m = square_depth_.at(i);
    cell.rays = rays_.rays.cells[i];
    cell.access_point_share = rays_.access_points.cells[i] /
                              static_cast<float>(std::max<std::size_t>(access_points_.size(), 1));
    cell.access_point_distance_m = static_cast<float>(nearestAccessPoint(i));
    cell.line_of_sight = has_rays ? std::exp(-rays_.least_loss.cells[i] / 4.0F) : 0.0F;
    cell.wall_strength = saturating(walls_.loss_db.cells[i], 1.5F);
    cell.wall_beside = saturating(strength_beside_.cells[i], 1.5F);
    cell.way_around = saturating(std::max(0.0F, paths_.cost.cells[i] - distance_m), 0.5F);
    cell.axis_distances = sortedAxisDistances(i);
    cell.small_coverage = small_coverage_[i];
    cell.large_coverage = large_coverage_[i];
    cell.source_alignment = alignment_.cells[source];
    cell.source_depth_m = disc_depth_.at(source);
    cell.explained_variance = limited_explained_variance_;
    return cell;
  }

  const std::atomic<bool>& stop_;
  const GridGeometry& geometry_;
  const std::vector<AccessPointBins>& access_points_;
  const WallField& walls_;
  Grid<double> distance_;  // to the path, in cells
  Mask footprint_;
  DepthGrids disc_depth_, square_depth_;
  RayEvidence rays_;
  Values strength_beside_;  // mean strength of walls around
  ShortestPaths paths_;
  Values alignment_;
  PathStyle style_;
  double explained_variance_;
  float limited_explained_variance_;
  std::vector<float> small_coverage_, large_coverage_;
  std::array<Values, 4> axis_distances_{Values(geometry_), Values(geometry_), Values(geometry_),
                                        Values(geometry_)};
};

}  // namespace

CellFeatures extractCellFeatures(const DrivenPath& path,
                                 const std::vector<AccessPointBins>& access_points,
                                 const WallField& walls, const std::atomic<bool>& stop,
                                 const ExplainedVarianceLimits& limits) {
  return CellFeatureExtractor(path, access_points, walls, stop, limits).extract();
}

}  // namespace sfw
