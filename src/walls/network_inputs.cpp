#include "walls/network_inputs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "base/log_odds.h"
#include "belief/free_probability.h"
#include "grid/axis_rasters.h"
#include "grid/morphology.h"
#include "grid/robot_evidence.h"
#include "walls/wall_rasters.h"

namespace sfw {
namespace {

constexpr float kFarthestM = 3.0F;  // of distances along axes, and the widest strip

/// The place of a feature in the vectors of the belief model.
constexpr std::size_t featureIndex(std::string_view name) {
  for (std::size_t i = 0; i < kCellFeatures; ++i) {
    if (name == kCellFeatureTable[i].name) {
      return i;
    }
  }
  return kCellFeatures;
}

/// Probabilities of free space by the belief model; 0.5 where cells are not described.
struct ModelProbabilities {
  Grid<float> single;        ///< of each cell by itself
  Grid<float> straightened;  ///< as freeProbability returns them
};

/// The belief model's probability of each cell by itself.
Grid<float> singleProbabilities(const CellFeatures& cells, const BeliefModel& model,
                                const StyleShares& style, UseRadio use_radio) {
  Grid<float> free(cells.geometry, kUnknownOccupancy);
  for (std::size_t i = 0; i < cells.cells.size(); ++i) {
    free.cells[cells.cells[i]] = static_cast<float>(model.free(cells.values[i], style, use_radio));
  }
  return free;
}

/// All evidence in one cell.
struct CellEvidence {
  FeatureVector features{};
  float loss_along_x_db = 0.0F;  ///< of walls along x, mean over the members
  float loss_along_y_db = 0.0F;
  float spread_along_x_db = 0.0F;
  float spread_along_y_db = 0.0F;
  float strip_along_x_db = 0.0F;  ///< loss of walls along x in the strip through the cell
  float strip_along_y_db = 0.0F;
  float in_strip_along_x = 0.0F;  ///< 1 in a strip between passes below and above
  float in_strip_along_y = 0.0F;  ///< 1 in a strip between passes to the left and right
  float rays_along_x = 0.0F;
  float rays_along_y = 0.0F;
  float heading_along_x = 0.0F;
  float heading_along_y = 0.0F;
  float on_path = 0.0F;
  std::array<float, 4> axis_distances_m{};  ///< to the left, right, below and above
  float log_odds_single = 0.0F;             ///< of free space, without radio
  float log_odds_straightened = 0.0F;
  float radio_log_odds_single = 0.0F;  ///< what radio adds to these
  float radio_log_odds_straightened = 0.0F;
  float explained_variance = 0.0F;
  float access_points = 0.0F;  ///< number of those with readings
};

struct NetworkInput {
  const char* name;
  bool uses_radio;
  float (*value)(const CellEvidence& cell);
};

template <std::size_t kFeature>
float feature(const CellEvidence& cell) {
  static_assert(kFeature < kCellFeatures, "the belief model has no such feature");
  return cell.features[kFeature];
}

float saturating(float value, float scale) { return 1.0F - std::exp(-value / scale); }

float logarithmic(float count) { return std::log2(1.0F + count) / 6.0F; }

/// Log odds of order one.
float scaled(float log_odds) { return 0.3F * log_odds; }

/// Each input is of order one.
constexpr NetworkInput kInputs[] = {
    {"path_close", false, feature<featureIndex("path_close")>},
    {"path_distance", false,
     [](const CellEvidence& c) { return 0.5F * feature<featureIndex("path_distance")>(c); }},
    {"path_near", false, feature<featureIndex("path_near")>},
    {"depth_disc_0.6", false, feature<featureIndex("depth_disc_0.6")>},
    {"depth_disc_1.2", false, feature<featureIndex("depth_disc_1.2")>},
    {"depth_disc_2.4", false, feature<featureIndex("depth_disc_2.4")>},
    {"depth_square_0.6", false, feature<featureIndex("depth_square_0.6")>},
    {"depth_square_1.2", false, feature<featureIndex("depth_square_1.2")>},
    {"depth_square_2.4", false, feature<featureIndex("depth_square_2.4")>},
    {"rays", false, feature<featureIndex("rays")>},
    {"access_points", false, feature<featureIndex("access_points")>},
    {"access_point_near", false, feature<featureIndex("access_point_near")>},
    {"coverage_0.6", false, feature<featureIndex("coverage_0.6")>},
    {"coverage_1.5", false, feature<featureIndex("coverage_1.5")>},
    {"source_alignment", false, feature<featureIndex("source_alignment")>},
    {"footprint_left", false,
     [](const CellEvidence& c) { return c.axis_distances_m[0] / kFarthestM; }},
    {"footprint_right", false,
     [](const CellEvidence& c) { return c.axis_distances_m[1] / kFarthestM; }},
    {"footprint_below", false,
     [](const CellEvidence& c) { return c.axis_distances_m[2] / kFarthestM; }},
    {"footprint_above", false,
     [](const CellEvidence& c) { return c.axis_distances_m[3] / kFarthestM; }},
    {"heading_along_x", false, [](const CellEvidence& c) { return c.heading_along_x; }},
    {"heading_along_y", false, [](const CellEvidence& c) { return c.heading_along_y; }},
    {"on_path", false, [](const CellEvidence& c) { return c.on_path; }},
    {"rays_along_x", false, [](const CellEvidence& c) { return logarithmic(c.rays_along_x); }},
    {"rays_along_y", false, [](const CellEvidence& c) { return logarithmic(c.rays_along_y); }},
    {"in_strip_along_y", false, [](const CellEvidence& c) { return c.in_strip_along_y; }},
    {"in_strip_along_x", false, [](const CellEvidence& c) { return c.in_strip_along_x; }},
    {"described", false, [](const CellEvidence&) { return 1.0F; }},
    {"log_odds_single", false, [](const CellEvidence& c) { return scaled(c.log_odds_single); }},
    {"log_odds_straightened", false,
     [](const CellEvidence& c) { return scaled(c.log_odds_straightened); }},
    {"line_of_sight", true, feature<featureIndex("line_of_sight")>},
    {"wall_strength", true, feature<featureIndex("wall_strength")>},
    {"wall_beside", true,
     [](const CellEvidence& c) { return 2.0F * feature<featureIndex("wall_beside")>(c); }},
    {"way_around", true, feature<featureIndex("way_around")>},
    {"loss_along_y", true,
     [](const CellEvidence& c) { return saturating(c.loss_along_y_db, 1.0F); }},
    {"loss_along_x", true,
     [](const CellEvidence& c) { return saturating(c.loss_along_x_db, 1.0F); }},
    {"spread_along_y", true,
     [](const CellEvidence& c) { return saturating(c.spread_along_y_db, 2.0F); }},
    {"spread_along_x", true,
     [](const CellEvidence& c) { return saturating(c.spread_along_x_db, 2.0F); }},
    {"strip_along_y", true,
     [](const CellEvidence& c) { return saturating(c.strip_along_y_db, 4.0F); }},
    {"strip_along_x", true,
     [](const CellEvidence& c) { return saturating(c.strip_along_x_db, 4.0F); }},
    {"radio_log_odds_single", true,
     [](const CellEvidence& c) { return scaled(c.radio_log_odds_single); }},
    {"radio_log_odds_straightened", true,
     [](const CellEvidence& c) { return scaled(c.radio_log_odds_straightened); }},
    {"explained_variance", true,
     [](const CellEvidence& c) {
       return 3.0F * (std::clamp(c.explained_variance, 0.2F, 0.95F) - 0.5F);
     }},
    {"access_point_count", true,
     [](const CellEvidence& c) { return std::log2(std::max(c.access_points, 1.0F)) / 4.0F; }},
    {"radio_used", true, [](const CellEvidence&) { return 1.0F; }},
};

/// Computes rasters over the whole grid first, and then the evidence of single cells.
class Evidence {
 public:
  Evidence(const DriveFeatures& features, const Mask& footprint, ModelProbabilities with_radio,
           ModelProbabilities without_radio)
      : features_(features),
        footprint_(footprint),
        with_radio_(std::move(with_radio)),
        without_radio_(std::move(without_radio)),
        geometry_(features.cells.geometry),
        loss_(directedLoss(features.walls, geometry_)),
        rays_(rayDirections(geometry_, features.access_points)),
        headings_(headings(features.path)),
        axis_distances_(axisDistances(footprint, kFarthestM)),
        strips_along_x_(strips(loss_.mean.along_x, false)),
        strips_along_y_(strips(loss_.mean.along_y, true)) {}

  /// The evidence in one of the described cells.
  /// @param number  of the cell among these
  CellEvidence of(std::size_t number) const {
    const std::size_t i = features_.cells.cells[number];
    CellEvidence cell;
    cell.features = features_.cells.values[number];
    cell.loss_along_x_db = loss_.mean.along_x.cells[i];
    cell.loss_along_y_db = loss_.mean.along_y.cells[i];
    cell.spread_along_x_db = loss_.spread.along_x.cells[i];
    cell.spread_along_y_db = loss_.spread.along_y.cells[i];
    cell.strip_along_x_db = strips_along_x_.sum.cells[i];
    cell.strip_along_y_db = strips_along_y_.sum.cells[i];
    cell.in_strip_along_x = static_cast<float>(strips_along_x_.in_strip.cells[i]);
    cell.in_strip_along_y = static_cast<float>(strips_along_y_.in_strip.cells[i]);
    cell.rays_along_x = rays_.along_x.cells[i];
    cell.rays_along_y = rays_.along_y.cells[i];
    cell.heading_along_x = headings_.along_x.cells[i];
    cell.heading_along_y = headings_.along_y.cells[i];
    cell.on_path = static_cast<float>(features_.path.cells.cells[i]);
    for (std::size_t side = 0; side < cell.axis_distances_m.size(); ++side) {
      cell.axis_distances_m[side] = axis_distances_[side].cells[i];
    }
    cell.log_odds_single = limitedLogOdds(without_radio_.single.cells[i]);
    cell.log_odds_straightened = limitedLogOdds(without_radio_.straightened.cells[i]);
    cell.radio_log_odds_single = limitedLogOdds(with_radio_.single.cells[i]) - cell.log_odds_single;
    cell.radio_log_odds_straightened =
        limitedLogOdds(with_radio_.straightened.cells[i]) - cell.log_odds_straightened;
    cell.explained_variance = static_cast<float>(features_.cells.explained_variance);
    cell.access_points = static_cast<float>(features_.access_points.size());
    return cell;
  }

 private:
  StripSums strips(const Grid<float>& loss, bool along_rows) const {
    Grid<float> per_cell(geometry_);  // a lattice's cell is two of these wide
    for (const std::size_t i : features_.cells.cells) {
      per_cell.cells[i] = 0.5F * loss.cells[i];
    }
    const std::int64_t widest = std::lround(kFarthestM / geometry_.resolution());
    const std::int64_t reach = std::lround(0.3 / geometry_.resolution());
    const GridLines lines(geometry_, along_rows);
    return stripSums(per_cell, lines, stretchesBeside(footprint_, lines, widest, 0).between_passes,
                     reach);
  }

  const DriveFeatures& features_;
  const Mask& footprint_;
  ModelProbabilities with_radio_, without_radio_;
  const GridGeometry& geometry_;
  DirectedLoss loss_;
  DirectedRasters rays_, headings_;
  std::array<Grid<float>, 4> axis_distances_;
  StripSums strips_along_x_, strips_along_y_;
};

}  // namespace

float limitedLogOdds(float probability) {
  constexpr double kLeast = 1e-3;
  return static_cast<float>(
      logit(std::clamp(static_cast<double>(probability), kLeast, 1.0 - kLeast)));
}

Mask footprintOf(const DrivenPath& path) {
  return dilated(path.cells, path.robot_radius_m / path.cells.geometry.resolution());
}

RowSource networkInputs(const DriveFeatures& features, const Mask& footprint,
                        const BeliefModel& model, const StyleShares& style, UseRadio use_radio,
                        const Grid<float>& free) {
  const CellFeatures& cells = features.cells;
  const auto evidence = std::make_shared<const Evidence>(
      features, footprint,
      ModelProbabilities{singleProbabilities(cells, model, style, use_radio), free},
      ModelProbabilities{singleProbabilities(cells, model, style, UseRadio::kNo),
                         freeProbability(cells, model, style, UseRadio::kNo)});
  const auto height = static_cast<std::size_t>(cells.geometry.height());
  const auto width = static_cast<std::size_t>(cells.geometry.width());
  return {std::size(kInputs), height, width,
          [evidence, use_radio, width, &described = cells.cells](std::size_t y, float* to,
                                                                 std::size_t stride) {
            for (std::size_t i = 0; i < std::size(kInputs); ++i) {
              std::fill_n(to + i * stride, width, 0.0F);
            }
            const auto first = std::lower_bound(described.begin(), described.end(), y * width);
            for (auto at = first; at != described.end() && *at < (y + 1) * width; ++at) {
              const CellEvidence cell =
                  evidence->of(static_cast<std::size_t>(at - described.begin()));
              float* value = to + *at - y * width;
              for (const NetworkInput& input : kInputs) {
                if (use_radio == UseRadio::kYes || !input.uses_radio) {
                  *value = input.value(cell);
                }
                value += stride;
              }
            }
          }};
}

std::vector<std::string> networkInputNames() {
  std::vector<std::string> names;
  for (const NetworkInput& input : kInputs) {
    names.emplace_back(input.name);
  }
  return names;
}

std::vector<std::string> networkRadioInputNames() {
  std::vector<std::string> names;
  for (const NetworkInput& input : kInputs) {
    if (input.uses_radio) {
      names.emplace_back(input.name);
    }
  }
  return names;
}

}  // namespace sfw
