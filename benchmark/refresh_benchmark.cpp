// Measures the CPU time of refreshing a live map of a long drive, by stages. A plain solution in
// the same run, which walks each ray in each iteration and multiplies by the dense precision, gives
// a ratio that does not depend on the machine.
//
// Usage: refresh_benchmark
// The drive passes a generated office floor of 400 m2 with three access points; it is cut after 5,
// 10, 30, 60 and 200 minutes, which is 6 km. The process has one thread.

#include <octomap/OcTree.h>
#include <ros/serialization.h>

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "belief/free_probability.h"
#include "comparison.h"
#include "long_drive.h"
#include "mapping/fused_belief.h"
#include "radio/shadowing.h"
#include "ros/conversion/markers.h"
#include "ros/conversion/message_conversion.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/octomap_export.h"
#include "walls/network_inputs.h"
#include "walls/network_walls.h"

namespace sfw {
namespace {

constexpr int kRepetitions = 3;  // the smallest time counts: other processes disturbed the others

/// The least CPU time [s] of some calls.
double seconds(const std::function<double()>& work) { return leastCpuSeconds(kRepetitions, work); }

/// Makes and serialises the messages that the nodelet publishes of a map.
double publishedBytes(const Snapshot& snapshot) {
  std_msgs::Header header;
  header.frame_id = "map";
  double bytes = 0.0;
  const auto send = [&](const auto& message) {
    bytes += static_cast<double>(ros::serialization::serializeMessage(message).num_bytes);
  };
  send(toTrinaryGrid(snapshot.belief, header));
  send(toProbabilityGrid(snapshot.probability, header));
  send(toWallLossGrid(snapshot.tomography->wall_loss, header));
  send(toPath(snapshot, header));
  send(toMarkers(snapshot, {}, header));
  send(toAccessPoints(snapshot, {}, header));
  send(toWalls(snapshot, header));
  return bytes;
}

/// Makes the OctoMaps, which the nodelet publishes only to subscribers.
double octomapBytes(const Snapshot& snapshot) {
  const auto tree = toOctomap(snapshot.belief, Config().octomap);
  return static_cast<double>(toBinaryOctomap(*tree, {}).data.size() +
                             toFullOctomap(*tree, {}).data.size());
}

DriveData mappedDrive(const Mapper& mapper, const std::vector<AccessPoint>& access_points) {
  DriveData drive;
  drive.access_points.resize(access_points.size());
  for (std::size_t i = 0; i < access_points.size(); ++i) {
    drive.access_points[i].access_point_in_map = access_points[i].position;
    drive.access_points[i].height_m = access_points[i].height_m;
  }
  for (const Reading& reading : mapper.readings()) {
    if (drive.path.empty() || drive.path.back() != reading.antenna_in_map) {
      drive.path.push_back(reading.antenna_in_map);
    }
    for (std::size_t i = 0; i < access_points.size(); ++i) {
      if (access_points[i].bssid == reading.bssid) {
        drive.access_points[i].samples.push_back({reading.antenna_in_map, reading.rssi_dbm});
      }
    }
  }
  return drive;
}

/// The precision of the first `count` bins of an access point.
SignalPrecision precisionOf(AccessPointBins access_point, std::size_t count,
                            const SignalCovariance& model) {
  access_point.bins.resize(count);
  return {access_point, model};
}

/// The time of all gradients of the ensemble, computed plainly, without the set-up.
double plainSeconds(const std::vector<AccessPointBins>& access_points,
                    const WallFieldConfig& config) {
  double sum = 0.0;
  for (const AccessPointBins& one : access_points) {
    Box box(one.position);
    for (const RadioBin& bin : one.bins) {
      box.extend(bin.position);
    }
    LineField field{LatticeLoss(LineLattice{GridGeometry::covering(
        box, config.line_resolution_m, config.line_resolution_m, 10000000)})};
    LatticeLoss& loss = field.front();
    const auto size = static_cast<Eigen::Index>((1.0 - config.holdout_fraction) *
                                                static_cast<double>(one.bins.size()));
    const Eigen::MatrixXd precision = Eigen::MatrixXd::Constant(size, size, 0.5);
    const GridGeometry& geometry = loss.lattice.geometry;
    sum += seconds([&] {
      Eigen::VectorXd losses(size);
      for (Eigen::Index i = 0; i < size; ++i) {
        losses[i] =
            lossBetween(field, one.position, one.bins[static_cast<std::size_t>(i)].position);
      }
      const Eigen::VectorXd pull = precision * losses;
      for (Eigen::Index i = 0; i < size; ++i) {
        forEachLine(geometry, one.position, one.bins[static_cast<std::size_t>(i)].position,
                    [&](bool walls_along_y, Cell c) {
                      (walls_along_y ? loss.walls_along_y : loss.walls_along_x)[c] +=
                          static_cast<float>(pull[i]);
                    });
      }
      return static_cast<double>(loss.walls_along_y.cells.front());
    });
  }
  return sum * 2.0 * config.line.iterations * config.ensemble_size;
}

std::size_t countBins(const std::vector<AccessPointBins>& access_points) {
  std::size_t bins = 0;
  for (const AccessPointBins& one : access_points) {
    bins += one.bins.size();
  }
  return bins;
}

/// The time of the precisions of the whole ensemble.
double precisionSeconds(const std::vector<AccessPointBins>& access_points,
                        const WallFieldConfig& config) {
  double sum = 0.0;
  for (const AccessPointBins& one : access_points) {
    const auto part = static_cast<std::size_t>((1.0 - config.holdout_fraction) *
                                               static_cast<double>(one.bins.size()));
    sum += config.ensemble_size * seconds([&] {
             return precisionOf(one, part, config.line.covariance)
                 .times(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(part)))
                 .sum();
           });
  }
  return sum;
}

/// The time of the network of walls: its inputs, its layers and the search of walls.
double networkSeconds(const DriveFeatures& described, const Config& config,
                      const std::atomic<bool>& never) {
  const BeliefModel model = configuredBeliefModel(config.belief);
  const WallNetwork network = shippedWallNetwork();
  const StyleShares style = model.shares(described.cells.style);
  const Grid<float> free = freeProbability(described.cells, model, style, UseRadio::kYes);
  return seconds([&] {
    return static_cast<double>(findWallsByNetwork(described, model, style, UseRadio::kYes, free,
                                                  1.0 - config.belief.free_threshold, network,
                                                  never)
                                   .free.cells.front());
  });
}

/// The settings with the cells that the mapper gives to the network, in all stages before it too.
Config configOfStages() {
  Config config;
  config.map.resolution_m = kNetworkCellM;
  return config;
}

void measure(benchmark::State& state, const Mapper& mapper,
             const std::vector<AccessPoint>& access_points) {
  const Config config = configOfStages();
  const std::atomic<bool> never{false};
  const DriveData drive = mappedDrive(mapper, access_points);
  const DriveFeatures described = extractDriveFeatures(drive, config, never, kTrustedVariance);
  WallFieldConfig walls;
  walls.line.max_total_wall_loss_db = std::numeric_limits<double>::infinity();
  walls.line.covariance.nugget_db2 = config.tomography.nugget_db * config.tomography.nugget_db;
  const DrivenPath& path = described.path;
  const double precision = precisionSeconds(described.access_points, walls);
  const double wall_field = seconds([&] {
    return estimateWalls(path.cells.geometry, described.access_points, path.cells,
                         path.robot_radius_m, walls, never)
        .ray_loss_db[0][0];
  });
  const double features = seconds([&] {
    return static_cast<double>(
        extractCellFeatures(path, described.access_points, described.walls, never).values[0][0]);
  });
  const double network = networkSeconds(described, config, never);
  const std::shared_ptr<const Snapshot> snapshot = mapper.infer();
  const double sorting = seconds([&] { return mapper.extent().min().x(); });
  const double octomaps = seconds([&] { return octomapBytes(*snapshot); });
  std::vector<double> inference, checks, publishing;
  while (state.KeepRunning()) {
    inference.push_back(cpuSeconds([&] {
      return static_cast<double>(mapper.infer()->belief.occupied({0, 0}));
    }));
    // While access points are due, a refresh checks them too.
    checks.push_back(cpuSeconds([&] {
      return static_cast<double>(DataChecker().checkChanged(*snapshot, never).fits.size());
    }));
    publishing.push_back(cpuSeconds([&] { return publishedBytes(*snapshot); }));
  }
  const double refresh = leastOf(inference) + leastOf(checks) + leastOf(publishing);
  const double plain = plainSeconds(described.access_points, walls);
  const std::pair<const char*, double> counters[] = {
      {"readings", static_cast<double>(mapper.readings().size())},
      {"bins", static_cast<double>(countBins(described.access_points))},
      {"cells", static_cast<double>(described.cells.cells.size())},
      {"precisions_s", precision},
      {"walls_with_these_s", wall_field},
      {"features_s", features},
      {"network_s", network},
      {"rest_s", leastOf(inference) - wall_field - features - network},
      {"sorting_s", sorting},
      {"checks_s", leastOf(checks)},
      {"publishing_s", leastOf(publishing)},
      {"refresh_s", refresh},
      {"octomaps_s", octomaps},
      {"plain_s", plain},
      {"plain_per_refresh", plain / refresh}};
  for (const auto& [name, value] : counters) {
    state.counters[name] = value;
  }
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  return sfw::runBenchmarks(count, arguments, [](const auto& /*none*/) {
    const auto scenario = std::make_shared<const sfw::Scenario>(sfw::longDrive());
    const auto recording =
        std::make_shared<const sfw::SimulatedRecording>(sfw::simulate(*scenario));
    for (const int minutes : {5, 10, 30, 60, 200}) {
      const std::string name = "refresh/" + std::to_string(minutes) + " min";
      benchmark::RegisterBenchmark(
          name.c_str(),
          [=](benchmark::State& state) {
            sfw::measure(state, sfw::mapperAfter(minutes, *scenario, recording->readings),
                         scenario->access_points);
          })
          ->Iterations(sfw::kRepetitions)
          ->Unit(benchmark::kMillisecond);
    }
  });
}
