// Measures what a dense radio environment costs: 10 scans a second with 50 access points each, on a
// map of 1000 x 1000 cells.
//
// Usage: scan_load_benchmark
// Prints, after 1, 2 and 5 minutes of driving, the CPU time of one map, and the share of a core
// that takes the readings in (conversion, transform, insertion). A map is made at most once a
// second, in one thread, so the node needs the first share and at most one core more.

#include <structure_from_wifi/WifiScan.h>
#include <tf2/buffer_core.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "comparison.h"
#include "ros/conversion/input_messages.h"
#include "ros/mapping/observation_queue.h"
#include "ros/mapping/shared_mapper.h"
#include "test/ros/any_message_of.h"

namespace sfw {
namespace {

constexpr int kScansPerSecond = 10;
constexpr int kAccessPoints = 50;
constexpr double kEdgeM = 46.0;  // with margins and whole steps of growth: 1000 cells of 0.05 m
constexpr double kSpeed = 0.5;   // [m/s]
constexpr double kStart = 1000.0;

/// Up and down, 2 m from lane to lane.
Position positionAt(double seconds) {
  constexpr double kLane = 2.0;
  const double way = kSpeed * seconds;
  const double lane = std::floor(way / kEdgeM);
  const double along = way - lane * kEdgeM;
  const bool forwards = std::fmod(lane, 2.0) < 1.0;
  return {forwards ? along : kEdgeM - along, std::fmod(lane * kLane, kEdgeM)};
}

std::vector<AccessPoint> accessPoints() {
  constexpr int kColumns = 10;
  constexpr int kRows = kAccessPoints / kColumns;
  std::vector<AccessPoint> access_points;
  for (int i = 0; i < kAccessPoints; ++i) {
    char bssid[18];
    std::snprintf(bssid, sizeof bssid, "02:00:00:00:00:%02x", i);
    AccessPoint access_point;
    access_point.bssid = *Bssid::parse(bssid);
    const int row = i / kColumns;
    access_point.position = {kEdgeM * (i % kColumns) / (kColumns - 1), kEdgeM * row / (kRows - 1)};
    access_points.push_back(access_point);
  }
  return access_points;
}

structure_from_wifi::WifiScan scanAt(double seconds, const std::vector<AccessPoint>& all) {
  structure_from_wifi::WifiScan scan;
  scan.header.stamp = ros::Time(kStart + seconds);
  for (const AccessPoint& access_point : all) {
    const double distance = (positionAt(seconds) - access_point.position).norm();
    structure_from_wifi::ApReading reading;
    reading.bssid = access_point.bssid.str();
    reading.rssi_dbm = static_cast<float>(
        std::round(-35.0 - 20.0 * std::log10(1.0 + distance) - 8.0 * std::floor(distance / 12.0)));
    scan.readings.push_back(reading);
  }
  return scan;
}

geometry_msgs::TransformStamped poseAt(double seconds) {
  geometry_msgs::TransformStamped pose;
  pose.header.stamp = ros::Time(kStart + seconds);
  pose.header.frame_id = "map";
  pose.child_frame_id = "base_link";
  pose.transform.translation.x = positionAt(seconds).x();
  pose.transform.translation.y = positionAt(seconds).y();
  pose.transform.rotation.w = 1.0;
  return pose;
}

/// Takes in the scans of some minutes and makes one map, whose time is that of the benchmark.
void measure(benchmark::State& state, int minutes) {
  const std::vector<AccessPoint> access_points = accessPoints();
  const RosSettings settings;
  SharedMapper mapper(Config(), access_points, jumpTolerance(settings));
  ObservationQueue queue(settings);
  tf2::BufferCore transforms(ros::Duration(settings.tf_cache_s));
  const std::atomic<bool> never{false};
  double intake = 0.0;
  for (int scans = 0; scans < 60 * minutes * kScansPerSecond; ++scans) {
    const double seconds = static_cast<double>(scans) / kScansPerSecond;
    const structure_from_wifi::WifiScan scan = scanAt(seconds, access_points);
    const AnyMessage message = anyMessageOf(scan);
    transforms.setTransform(poseAt(seconds), "benchmark");
    intake += cpuSeconds([&] {
      queue.push(convertReadings(message, {}).observations);
      queue.locate(transforms, scan.header.stamp,
                   [&](const LocatedObservation& observation) { mapper.insert(observation); });
      return 0.0;
    });
  }
  std::shared_ptr<const Snapshot> snapshot;
  while (state.KeepRunning()) {
    snapshot = mapper.corrected({}).mapper.infer(never);
  }
  const GridGeometry& geometry = snapshot->belief.geometry();
  state.counters["readings"] = static_cast<double>(mapper.readings());
  state.counters["width"] = static_cast<double>(geometry.width());
  state.counters["height"] = static_cast<double>(geometry.height());
  state.counters["intake_share_of_core"] = intake / (60.0 * minutes);
}

}  // namespace
}  // namespace sfw

int main(int count, char** arguments) {
  return sfw::runBenchmarks(count, arguments, [](const auto& /*none*/) {
    for (const int minutes : {1, 2, 5}) {
      const std::string name = "map/after " + std::to_string(minutes) + " min";
      benchmark::RegisterBenchmark(name.c_str(),
                                   [=](benchmark::State& state) { sfw::measure(state, minutes); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  });
}
