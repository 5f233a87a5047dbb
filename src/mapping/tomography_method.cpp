#include <cmath>
#include <utility>

#include "belief/belief_model.h"
#include "mapping/fused_belief.h"
#include "mapping/map_method.h"

namespace sfw {
namespace {

/// The number of interior walls with such a loss (5 dB each, ns-3's default).
int wallsOf(double loss_db) {
  constexpr double kUsualWall = 5.0;  // [dB]
  return static_cast<int>(std::lround(loss_db / kUsualWall));
}

std::vector<int> wallsOf(const std::vector<double>& losses_db) {
  std::vector<int> walls;
  walls.reserve(losses_db.size());
  for (const double loss_db : losses_db) {
    walls.push_back(wallsOf(loss_db));
  }
  return walls;
}

TomographySummary::YawSource toYawSource(BuildingFrame::Source source) {
  switch (source) {
    case BuildingFrame::Source::kHeadings:
      return TomographySummary::YawSource::kHeadings;
    case BuildingFrame::Source::kSpread:
      return TomographySummary::YawSource::kSpread;
    case BuildingFrame::Source::kNone:
      break;
  }
  return TomographySummary::YawSource::kNone;
}

TomographySummary summaryOf(FusedBelief&& fused) {
  const auto share = [&](DrivingStyle style) {
    return fused.style[static_cast<std::size_t>(style)];
  };
  return {std::move(fused.wall_loss),
          fused.frame.yaw_rad,
          toYawSource(fused.frame.source),
          {share(DrivingStyle::kAlongWalls), share(DrivingStyle::kPatrol),
           share(DrivingStyle::kStroll)},
          fused.explained_variance};
}

/// Line-field tomography and the fused belief (doc/method/walls.md, doc/method/belief.md).
class TomographyMethod : public MapMethod {
 public:
  explicit TomographyMethod(const Config& config)
      : config_(config), model_(configuredBeliefModel(config.belief)) {
    if (config.belief.walls == "network") {
      network_ = shippedWallNetwork();
    }
  }

  MethodResult infer(const GridGeometry& geometry, Inliers& inliers,
                     const std::vector<AccessPointSummary>& access_points, UseRadio use_radio,
                     const std::atomic<bool>& stop, KeptFeatures* kept) const override {
    DriveData drive{positionsOf(inliers.path, config_.path.max_gap_m), {}, inliers.contacts};
    std::vector<std::size_t> used;  // index of each access point in the drive
    for (std::size_t i = 0; i < access_points.size(); ++i) {
      std::vector<Sample>& samples = inliers.readings[i].samples;
      if (isPlaced(access_points[i]) && !samples.empty()) {
        const AccessPoint& access_point = access_points[i].access_point;
        drive.access_points.push_back(
            {access_point.position, access_point.height_m, std::move(samples)});
        if (access_points[i].estimate) {
          drive.access_points.back().covariance_in_map = access_points[i].estimate->covariance;
        }
        used.push_back(i);
      }
    }
    FusedBelief fused = inferOccupancyByTomography(geometry, drive, model_, network_, config_,
                                                   use_radio, stop, kept);
    MethodResult result{std::move(fused.occupied), std::move(fused.probability)};
    result.walls.resize(access_points.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
      inliers.readings[used[i]].samples = std::move(drive.access_points[i].samples);
      result.walls[used[i]] = wallsOf(fused.sample_loss_db[i]);
    }
    result.wall_segments = std::move(fused.walls);
    result.tomography = summaryOf(std::move(fused));
    return result;
  }

 private:
  Config config_;
  BeliefModel model_;
  std::optional<WallNetwork> network_;  // finds walls between passes of the robot
};

}  // namespace

std::unique_ptr<const MapMethod> makeTomographyMethod(const Config& config) {
  return std::make_unique<TomographyMethod>(config);
}

}  // namespace sfw
