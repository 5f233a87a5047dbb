#include "training/wall_drive.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>

#include "base/random_streams.h"
#include "belief/belief_model.h"
#include "belief/drive_features.h"
#include "belief/free_probability.h"
#include "grid/for_each_cell.h"
#include "grid/morphology.h"
#include "mapping/fused_belief.h"
#include "mapping/inliers.h"
#include "training/disturbance.h"
#include "training/survey.h"
#include "walls/network_inputs.h"

namespace sfw {
namespace {

constexpr double kSurveyGap = 2.0;  // [m], between successive places of a survey

bool happens(double probability, Random& random) { return random.uniform() <= probability; }

TrainingDriveSettings chooseSettings(const NoiseLevel& level, std::int64_t seed, Random& random) {
  TrainingDriveSettings settings;
  settings.scenario.seed = seed;
  settings.scenario.noise = level;
  settings.scenario.access_points = chooseCount(kMostAccessPoints, random);
  settings.plain = happens(0.3, random);
  settings.varies_radio = !settings.plain || happens(0.5, random);
  if (!settings.plain) {
    settings.scenario.robot_radius_m = random.uniform(0.01, 0.15);
  }
  return settings;
}

DrivingStyle styleOf(WallDriveKind kind) {
  return kind == WallDriveKind::kAlongWalls ? DrivingStyle::kAlongWalls
         : kind == WallDriveKind::kPatrol   ? DrivingStyle::kPatrol
                                            : DrivingStyle::kStroll;
}

/// The data of a drive as the mapper prepares them.
DriveData dataOf(const TrainingDrive& drive) {
  std::map<Bssid, std::size_t> index;
  for (std::size_t i = 0; i < drive.access_points.size(); ++i) {
    index[drive.access_points[i].bssid] = i;
  }
  const Inliers inliers = withoutStrayPoses(sortedByStamp(drive.readings), {}, index);
  DriveData data{positionsOf(inliers.path, Config().path.max_gap_m), {}, {}};
  for (std::size_t i = 0; i < drive.access_points.size(); ++i) {
    if (!inliers.readings[i].samples.empty()) {
      const AccessPoint& access_point = drive.access_points[i];
      data.access_points.push_back(
          {access_point.position, access_point.height_m, inliers.readings[i].samples});
    }
  }
  return data;
}

/// Writes the share of each cell that has a state. The truth has other cells and another frame.
void fillShares(const Grid<CellState>& truth, CellState state, const DriveFeatures& features,
                float* to) {
  constexpr int kParts = 2;  // of a cell's edge
  const GridGeometry& geometry = features.cells.geometry;
  const double step_m = geometry.resolution() / kParts;
  forEachCell(geometry, [&](Cell c) {
    const Position corner = geometry.centre(c) - 0.5 * (kParts - 1) * Position(step_m, step_m);
    int count = 0;
    forEachCell({0, 0}, {kParts - 1, kParts - 1}, [&](Cell part) {
      const Position at =
          corner + step_m * Position(static_cast<double>(part.x), static_cast<double>(part.y));
      const Cell in_truth = truth.geometry.cellAt(features.frame.toMap(at));
      count += truth.geometry.contains(in_truth) && truth[in_truth] == state ? 1 : 0;
    });
    *to++ = static_cast<float>(count) / (kParts * kParts);
  });
}

/// Removes connected pieces of a set that are shorter than a metre along both axes.
Mask withoutShortPieces(const Mask& mask) {
  constexpr double kShortest = 1.0;  // [m]
  const Components pieces = labelComponents(mask);
  std::vector<Eigen::AlignedBox2d> extents(static_cast<std::size_t>(pieces.count) + 1);
  forEachCell(mask.geometry, [&](Cell c) {
    extents[static_cast<std::size_t>(pieces.label[c])].extend(mask.geometry.centre(c));
  });
  const double longest_m = kShortest - 1.5 * mask.geometry.resolution();  // of centres
  Mask kept = mask;
  for (std::size_t i = 0; i < mask.cells.size(); ++i) {
    const auto label = static_cast<std::size_t>(pieces.label.cells[i]);
    kept.cells[i] = label != 0 && extents[label].sizes().maxCoeff() > longest_m ? 1 : 0;
  }
  return kept;
}

void fillTrueWalls(const Grid<CellState>& building, const DriveFeatures& features, float* to) {
  constexpr float kWallShare = 0.25F;  // of a cell that counts as wall
  Grid<float> shares(features.cells.geometry);
  fillShares(building, CellState::kOccupied, features, shares.cells.data());
  Mask walls(features.cells.geometry);
  for (std::size_t i = 0; i < walls.cells.size(); ++i) {
    walls.cells[i] = shares.cells[i] >= kWallShare ? 1 : 0;
  }
  const Mask long_walls = withoutShortPieces(walls);
  std::copy(long_walls.cells.begin(), long_walls.cells.end(), to);
}

}  // namespace

const char* nameOf(WallDriveKind kind) {
  return kind == WallDriveKind::kSurvey
             ? "survey"
             : kDrivingStyleNames[static_cast<std::size_t>(styleOf(kind))];
}

WallDriveKind chooseWallDriveKind(std::int64_t seed) {
  const double draw = Random(seed, streamOf(Purpose::kWallDrive), 1).uniform();
  return draw < 0.2    ? WallDriveKind::kSurvey
         : draw < 0.64 ? WallDriveKind::kAlongWalls
         : draw < 0.8  ? WallDriveKind::kPatrol
                       : WallDriveKind::kStroll;
}

std::optional<WallDrive> makeWallDrive(const FloorPlan& plan, WallDriveKind kind,
                                       std::int64_t seed) {
  constexpr std::size_t kFewestPositions = 30;
  Random random(seed, streamOf(Purpose::kWallDrive), 0);
  const NoiseLevel level = chooseNoise(random);
  std::optional<TrainingDrive> made =
      kind == WallDriveKind::kSurvey
          ? makeSurvey(plan, level, seed, random)
          : simulateTrainingDrive(plan, styleOf(kind), chooseSettings(level, seed, random), random);
  if (!made || pathOf(made->readings).size() < kFewestPositions) {
    return std::nullopt;
  }
  disturb(*made, level, seed);
  return WallDrive{kind, std::string(level.name), std::move(*made)};
}

Channels wallRasters(const WallDrive& drive, Config config) {
  config.map.resolution_m = kNetworkCellM;
  if (drive.kind == WallDriveKind::kSurvey) {
    config.path.max_gap_m = kSurveyGap;
  }
  const std::atomic<bool> never{false};
  const DriveFeatures features =
      extractDriveFeatures(dataOf(drive.drive), config, never, kTrustedVariance);
  const BeliefModel model = configuredBeliefModel(config.belief);
  const StyleShares style = model.shares(features.cells.style);
  const Mask footprint = footprintOf(features.path);
  const Grid<float> free = freeProbability(features.cells, model, style, UseRadio::kYes);
  const Channels inputs =
      channelsOf(networkInputs(features, footprint, model, style, UseRadio::kYes, free));
  Channels rasters(inputs.count() + wallLabelNames().size(), inputs.height(), inputs.width());
  std::copy(inputs.values().begin(), inputs.values().end(), rasters.values().begin());
  const auto label = [&](std::size_t number) { return rasters.row(inputs.count() + number, 0); };
  std::copy(footprint.cells.begin(), footprint.cells.end(), label(0));
  fillShares(drive.drive.truth, CellState::kFree, features, label(1));
  fillShares(drive.drive.truth, CellState::kOccupied, features, label(2));
  fillTrueWalls(drive.drive.building, features, label(3));
  return rasters;
}

std::vector<std::string> wallLabelNames() { return {"footprint", "free", "wall", "true_walls"}; }

}  // namespace sfw
