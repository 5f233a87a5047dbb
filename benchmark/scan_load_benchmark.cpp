// Measures what a dense radio environment costs: 10 scans a second with 50 access points each, on a
// map of 1000 x 1000 cells.
//
// Usage: scan_load_benchmark
// Prints, after 1, 2 and 5 minutes of driving, the share of a core that takes the readings in
// (conversion, transform, insertion), and the CPU time of one map. A map is made at most once a
// second, in one thread, so the node needs the first share and at most one core more.

#include <structure_from_wifi/WifiScan.h>
#include <tf2/buffer_core.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <vector>

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

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

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
  std::vector<AccessPoint> access_points;
  for (int i = 0; i < kAccessPoints; ++i) {
    char bssid[18];
    std::snprintf(bssid, sizeof bssid, "02:00:00:00:00:%02x", i);
    AccessPoint access_point;
    access_point.bssid = *Bssid::parse(bssid);
    access_point.position = {kEdgeM * (i % kColumns) / (kColumns - 1),
                             kEdgeM * (i / kColumns) / (kAccessPoints / kColumns - 1)};
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

void run() {
  const std::vector<AccessPoint> access_points = accessPoints();
  const RosSettings settings;
  SharedMapper mapper(Config(), access_points, jumpTolerance(settings));
  ObservationQueue queue(settings);
  tf2::BufferCore transforms(ros::Duration(settings.tf_cache_s));
  const std::atomic<bool> never{false};
  std::puts(
      "| drive | readings | cells | intake, share of a core | one map [s] "
      "|\n|---|---|---|---|---|");
  int scans = 0;
  double intake = 0.0;
  for (const int minutes : {1, 2, 5}) {
    for (; scans < 60 * minutes * kScansPerSecond; ++scans) {
      const double seconds = static_cast<double>(scans) / kScansPerSecond;
      const structure_from_wifi::WifiScan scan = scanAt(seconds, access_points);
      const AnyMessage message = anyMessageOf(scan);
      transforms.setTransform(poseAt(seconds), "benchmark");
      const double start = cpuSeconds();
      queue.push(convertReadings(message, {}).observations);
      queue.locate(transforms, scan.header.stamp,
                   [&](const LocatedObservation& observation) { mapper.insert(observation); });
      intake += cpuSeconds() - start;
    }
    const double start = cpuSeconds();
    const auto snapshot = mapper.corrected({}).mapper.infer(never);
    const double one_map = cpuSeconds() - start;
    const GridGeometry& geometry = snapshot->belief.geometry();
    std::printf("| %d min | %zu | %ld x %ld | %.4f | %.2f |\n", minutes, mapper.readings(),
                static_cast<long>(geometry.width()), static_cast<long>(geometry.height()),
                intake / (60.0 * minutes), one_map);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace sfw

int main() {
  try {
    sfw::run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scan_load_benchmark: %s\n", error.what());
    return 1;
  }
  return 0;
}
