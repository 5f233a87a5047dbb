// Measures the CPU time of estimateWalls. Dense products with the precision, in the same run, are
// the reference. Without sparse shadowing, the same solution would need these products.
//
// Usage: wall_field_benchmark [READINGS.csv ACCESS_POINTS.yaml]
// It runs on a drive through a generated office floor of 400 m2, and on a recording if one is
// given.

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "comparison.h"
#include "office_floor.h"
#include "radio/radio_bins.h"
#include "simulation/radio/noise_level.h"
#include "simulation/radio/radio_model.h"
#include "simulation/robot/route_planner.h"
#include "simulation/scenario.h"
#include "structure_from_wifi/access_points_io.h"
#include "structure_from_wifi/readings_io.h"
#include "tomography/wall_field.h"

namespace sfw {
namespace {

constexpr int kRepetitions = 3;  // the smallest time counts: other processes disturbed the others
constexpr double kBin = 0.2;     // [m]
constexpr double kMargin = 1.0;  // [m]
constexpr double kResolution = 0.05;
constexpr double kRadius = 0.15;  // [m], of the robot

/// The time of all products with dense matrices that the members' solutions need. One product of
/// each matrix is measured.
double denseSeconds(const std::vector<AccessPointBins>& access_points,
                    const WallFieldConfig& config) {
  double sum = 0.0;
  for (const AccessPointBins& one : access_points) {
    const double share = config.ensemble_size > 1 ? 1.0 - config.holdout_fraction : 1.0;
    const auto size = static_cast<Eigen::Index>(share * static_cast<double>(one.bins.size()));
    const Eigen::MatrixXd precision = Eigen::MatrixXd::Constant(size, size, 0.5);
    const Eigen::VectorXd residual = Eigen::VectorXd::Ones(size);
    sum +=
        leastCpuSeconds(kRepetitions, [&] { return Eigen::VectorXd(precision * residual).sum(); });
  }
  return sum * 2.0 * config.line.iterations * config.ensemble_size;
}

/// A drive, binned.
struct Drive {
  std::vector<AccessPointBins> access_points;
  std::vector<Position> path;
};

void measure(benchmark::State& state, const Drive& drive) {
  const auto& [access_points, path] = drive;
  Box box;
  for (const AccessPointBins& one : access_points) {
    box.extend(one.position);
  }
  for (const Position& position : path) {
    box.extend(position);
  }
  box.extend(Position(box.min().array() - kMargin));
  box.extend(Position(box.max().array() + kMargin));
  const GridGeometry geometry = GridGeometry::covering(box, kResolution, kResolution, 100000000);
  Mask driven(geometry);
  for (const Position& position : path) {
    driven[geometry.cellAt(position)] = 1;
  }
  const WallFieldConfig config;
  const std::atomic<bool> never{false};
  std::vector<double> ours;
  while (state.KeepRunning()) {
    ours.push_back(cpuSeconds([&] {
      return estimateWalls(geometry, drive.access_points, driven, kRadius, config, never)
          .ray_loss_db[0][0];
    }));
  }
  const double dense = denseSeconds(access_points, config);
  std::size_t bins = 0;
  for (const AccessPointBins& one : access_points) {
    bins += one.bins.size();
  }
  state.counters["access_points"] = static_cast<double>(access_points.size());
  state.counters["bins"] = static_cast<double>(bins);
  state.counters["cells"] = static_cast<double>(geometry.size());
  state.counters["walls_s"] = leastOf(ours);
  state.counters["us_per_bin"] = 1e6 * leastOf(ours) / static_cast<double>(bins);
  state.counters["dense_s"] = dense;
  state.counters["dense_per_walls"] = dense / leastOf(ours);
}

/// Bins every 0.2 m of a drive along the walls, repeated until there are enough.
Drive officeDrive(std::size_t count, std::int64_t access_points) {
  const FloorPlan plan = officeFloor();
  const RadioModel radio(plan, asTransmitters(placeAccessPoints(plan, access_points, 1)),
                         radioConfig(noiseLevel("realistic"), 1));
  const Route route(planRoute(toStates(plan), RouteKind::kWalls), 1.0, 1000.0);
  std::vector<Position> path;
  std::vector<AccessPointBins> binned(radio.transmitters().size());
  for (std::size_t i = 0; i < binned.size(); ++i) {
    binned[i].position = radio.transmitters()[i].access_point.position;
    binned[i].noise_db2 = 9.0;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double time = std::fmod(kBin * static_cast<double>(i), route.duration());
    const RobotPose pose = route.poseAt(time);
    path.push_back(pose.position);
    for (std::size_t j = 0; j < binned.size(); ++j) {
      binned[j].bins.push_back({pose.position, radio.meanRssi(j, pose), 1.0});
    }
  }
  return {binned, path};
}

Drive recordedDrive(const std::string& readings, const std::string& access_points) {
  std::vector<AccessPointBins> binned;
  std::vector<Position> path;
  const ReadingFile file = readReadings(readings);
  for (const Reading& reading : file.readings) {
    path.push_back(reading.antenna_in_map);
  }
  const BuildingFrame frame = findBuildingFrame(path, 1.0);
  for (Position& position : path) {
    position = frame.toBuilding(position);
  }
  for (const AccessPoint& one : readAccessPoints(access_points).access_points) {
    std::vector<Sample> samples;
    for (const Reading& reading : file.readings) {
      if (reading.bssid == one.bssid) {
        samples.push_back({reading.antenna_in_map, reading.rssi_dbm});
      }
    }
    if (!samples.empty()) {
      binned.push_back(binSamples(samples, one.position, one.height_m, frame, kBin));
    }
  }
  return {binned, path};
}

/// @param drive  makes the drive when the benchmark runs
void declare(const std::string& name, const std::function<Drive()>& drive) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { measure(state, drive()); })
      ->Iterations(kRepetitions)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  return sfw::runBenchmarks(count, arguments, [](const std::vector<std::string>& files) {
    for (const auto& [bins, access_points] :
         {std::pair{500, 1}, {1000, 1}, {2000, 1}, {4500, 1}, {4500, 3}, {4500, 5}}) {
      sfw::declare("office/" + std::to_string(bins) + '/' + std::to_string(access_points),
                   [bins = static_cast<std::size_t>(bins), count = access_points] {
                     return sfw::officeDrive(bins, count);
                   });
    }
    if (files.size() == 2) {
      sfw::declare("recording", [=] { return sfw::recordedDrive(files[0], files[1]); });
    }
  });
}
