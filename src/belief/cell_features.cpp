#include "belief/cell_features.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "belief/ray_evidence.h"
#include "belief/shortest_paths.h"
#include "grid/axis_rasters.h"
#include "grid/distance_transform.h"
#include "grid/morphology.h"
#include "radio/path_loss.h"

namespace sfw {
namespace {

using Values = Grid<float>;

/// Numbers of the features that wall losses make, and of the first of those made of them.
constexpr std::array<std::size_t, 4> kOfWalls{11, 13, 14, 15};
constexpr std::size_t kExplained = 26;

/// Depth inside a set, positive, or distance to it, negative [m]; cut where it stops to matter.
Values signedDepth(const Mask& set) {
  constexpr double kDeepest = 1.2;  // [m]
  const Grid<double> to_outside = distanceTransform(complement(set));
  const Grid<double> to_set = distanceTransform(set);
  const double resolution = set.geometry.resolution();
  Values depth(set.geometry);
  for (std::size_t i = 0; i < depth.cells.size(); ++i) {
    depth.cells[i] = static_cast<float>(std::min(resolution * to_outside.cells[i], kDeepest) -
                                        std::min(resolution * to_set.cells[i], kDeepest));
  }
  return depth;
}

/// 0 for nothing, towards 1 beyond `scale`.
float saturating(float value, float scale) { return 1.0F - std::exp(-value / scale); }

/// By how much a value passes a limit. A line bent there may say more than a straight one.
float over(float value, float limit) { return std::max(0.0F, value - limit); }

/// Everything that is computed for the whole grid before single cells are described.
class CellFeatureExtractor {
 public:
  CellFeatureExtractor(const DrivenPath& path, const std::vector<AccessPointBins>& heard,
                       const WallField& walls, const std::atomic<bool>& stop)
      : stop_(stop),
        geometry_(path.cells.geometry),
        heard_(heard),
        walls_(walls),
        distance_(distanceTransform(path.cells)),
        footprint_(geometry_),
        disc_small_(depthOf([&] { return closed(path.cells, inCells(0.6)); })),
        disc_middle_(depthOf([&] { return withHolesFilled(closed(path.cells, inCells(1.2))); })),
        disc_large_(depthOf([&] { return withHolesFilled(closed(path.cells, inCells(2.4))); })),
        square_small_(depthOf([&] { return closedWithSquare(path.cells, wholeCells(0.6)); })),
        square_middle_(depthOf(
            [&] { return withHolesFilled(closedWithSquare(path.cells, wholeCells(1.2))); })),
        square_large_(depthOf(
            [&] { return withHolesFilled(closedWithSquare(path.cells, wholeCells(2.4))); })),
        rays_(rayEvidence(geometry_, heard, walls.ray_loss_db, stop)),
        beside_(boxMean(walls.loss_db, wholeCells(0.2))),
        ways_(shortestPathsFrom(path.cells, distance_, walls.loss_db, stop)),
        alignment_(axisAlignment(geometry_, path.driven, path.max_gap_m)),
        style_(measurePathStyle(path.cells, disc_middle_, path.driven, path.max_gap_m)),
        explained_(explainedVariance(heard, walls.ray_loss_db)) {
    Values covered(geometry_);
    for (std::size_t i = 0; i < distance_.cells.size(); ++i) {
      footprint_.cells[i] =
          distance_.cells[i] * geometry_.resolution() <= path.robot_radius_m ? 1 : 0;
      covered.cells[i] = static_cast<float>(footprint_.cells[i]);
    }
    coverage_near_ = boxMean(covered, wholeCells(0.6)).cells;
    coverage_far_ = boxMean(covered, wholeCells(1.5)).cells;
    along_ = axisDistances(footprint_, kFarthestAlong);
  }

  CellFeatures describe() const {
    CellFeatures features{geometry_, {}, {}, style_, explained_};
    for (std::size_t i = 0; i < distance_.cells.size() && !stop_; ++i) {
      if (distance_.cells[i] * geometry_.resolution() <= kMaxDistanceToPath) {
        features.cells.push_back(i);
        features.values.push_back(describe(i));
      }
    }
    return features;
  }

 private:
  static constexpr float kFarthestAlong = 3.0F;  // [m]

  /// Depth in a set; it is not made any more when all shall stop.
  template <class MakeSet>
  Values depthOf(MakeSet&& make) const {
    const Mask set = stop_ ? Mask(geometry_) : make();
    return stop_ ? Values(geometry_) : signedDepth(set);
  }

  double inCells(double metres) const { return metres / geometry_.resolution(); }
  std::int64_t wholeCells(double metres) const { return std::lround(inCells(metres)); }

  double nearestAccessPoint(std::size_t i) const {
    double nearest = kFarthestAlong;
    const Position centre = geometry_.centre(geometry_.cell(i));
    for (const AccessPointBins& one : heard_) {
      nearest = std::min(nearest, (one.position - centre).norm());
    }
    return nearest;
  }

  /// Distances to the footprints along the axes: the nearer side of an axis first, and the axis
  /// with the nearest of all.
  std::array<float, 4> sortedAlong(std::size_t i) const {
    std::array<std::array<float, 2>, 2> axes{
        {{along_[0].cells[i], along_[1].cells[i]}, {along_[2].cells[i], along_[3].cells[i]}}};
    for (auto& axis : axes) {
      std::sort(axis.begin(), axis.end());
    }
    std::sort(axes.begin(), axes.end());
    return {axes[0][0] / kFarthestAlong, axes[0][1] / kFarthestAlong, axes[1][0] / kFarthestAlong,
            axes[1][1] / kFarthestAlong};
  }

  std::array<float, kCellFeatures> describe(std::size_t i) const {
    const auto d = static_cast<float>(distance_.cells[i] * geometry_.resolution());
    const bool seen = rays_.rays.cells[i] > 0.0F;
    const auto access_points = static_cast<float>(std::max<std::size_t>(heard_.size(), 1));
    const std::array<float, 4> along = sortedAlong(i);
    const std::size_t source = ways_.source.cells[i];
    const float line_of_sight = seen ? std::exp(-rays_.least_loss.cells[i] / 4.0F) : 0.0F;
    const float wall_strength = saturating(walls_.loss_db.cells[i], 1.5F);
    const float wall_beside = saturating(beside_.cells[i], 1.5F);
    const float way_around = saturating(std::max(0.0F, ways_.cost.cells[i] - d), 0.5F);
    const auto explained = static_cast<float>(explained_);
    return {std::exp(-d / 0.1F),
            d,
            std::exp(-d / 0.4F),
            disc_small_.cells[i],
            disc_middle_.cells[i],
            disc_large_.cells[i],
            square_small_.cells[i],
            square_middle_.cells[i],
            square_large_.cells[i],
            std::min(std::log2(1.0F + rays_.rays.cells[i]), 6.0F) / 6.0F,
            rays_.access_points.cells[i] / access_points,
            line_of_sight,
            std::exp(-static_cast<float>(nearestAccessPoint(i))),
            wall_strength,
            wall_beside,
            way_around,
            along[0],
            along[1],
            along[2],
            along[3],
            coverage_near_[i],
            coverage_far_[i],
            alignment_.cells[source],
            disc_small_.cells[source],
            disc_middle_.cells[source],
            disc_large_.cells[source],
            explained,
            explained * line_of_sight,
            explained * wall_strength,
            explained * wall_beside,
            explained * way_around,
            over(line_of_sight, 0.1F),
            over(line_of_sight, 0.4F),
            over(wall_strength, 0.1F),
            over(wall_beside, 0.02F),
            over(wall_beside, 0.1F),
            over(way_around, 0.1F),
            over(way_around, 0.25F)};
  }

  const std::atomic<bool>& stop_;
  const GridGeometry& geometry_;
  const std::vector<AccessPointBins>& heard_;
  const WallField& walls_;
  Grid<double> distance_;  // to the path, in cells
  Mask footprint_;
  Values disc_small_, disc_middle_, disc_large_, square_small_, square_middle_, square_large_;
  RayEvidence rays_;
  Values beside_;  // mean wall strength around
  ShortestPaths ways_;
  Values alignment_;
  PathStyle style_;
  double explained_;  // share of the signals that walls explain
  std::vector<float> coverage_near_, coverage_far_;
  std::array<Values, 4> along_{Values(geometry_), Values(geometry_), Values(geometry_),
                               Values(geometry_)};
};

}  // namespace

const std::array<const char*, kCellFeatures>& cellFeatureNames() {
  static constexpr std::array<const char*, kCellFeatures> kNames{"path_close",
                                                                 "path_distance",
                                                                 "path_near",
                                                                 "depth_disc_0.6",
                                                                 "depth_disc_1.2",
                                                                 "depth_disc_2.4",
                                                                 "depth_square_0.6",
                                                                 "depth_square_1.2",
                                                                 "depth_square_2.4",
                                                                 "rays",
                                                                 "access_points",
                                                                 "line_of_sight",
                                                                 "access_point_near",
                                                                 "wall_strength",
                                                                 "wall_beside",
                                                                 "way_around",
                                                                 "nearest_along",
                                                                 "opposite_along",
                                                                 "nearest_across",
                                                                 "opposite_across",
                                                                 "coverage_0.6",
                                                                 "coverage_1.5",
                                                                 "source_alignment",
                                                                 "source_depth_0.6",
                                                                 "source_depth_1.2",
                                                                 "source_depth_2.4",
                                                                 "explained",
                                                                 "explained_line_of_sight",
                                                                 "explained_wall_strength",
                                                                 "explained_wall_beside",
                                                                 "explained_way_around",
                                                                 "line_of_sight_over_0.1",
                                                                 "line_of_sight_over_0.4",
                                                                 "wall_strength_over_0.1",
                                                                 "wall_beside_over_0.02",
                                                                 "wall_beside_over_0.1",
                                                                 "way_around_over_0.1",
                                                                 "way_around_over_0.25"};
  return kNames;
}

bool usesRadio(std::size_t feature) {
  return feature >= kExplained ||
         std::find(kOfWalls.begin(), kOfWalls.end(), feature) != kOfWalls.end();
}

CellFeatures extractCellFeatures(const DrivenPath& path, const std::vector<AccessPointBins>& heard,
                                 const WallField& walls, const std::atomic<bool>& stop) {
  return CellFeatureExtractor(path, heard, walls, stop).describe();
}

void clampExplainedVariance(double least, double most, CellFeatures& features) {
  features.explained = std::clamp(features.explained, least, most);
  const auto explained = static_cast<float>(features.explained);
  for (std::array<float, kCellFeatures>& cell : features.values) {
    cell[kExplained] = explained;
    for (std::size_t i = 0; i < kOfWalls.size(); ++i) {
      cell[kExplained + 1 + i] = explained * cell[kOfWalls[i]];
    }
  }
}

}  // namespace sfw
