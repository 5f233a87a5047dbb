#include "ros/mapping/scan_localisation.h"

#include <geometry_msgs/TransformStamped.h>
#include <ros/console.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/constants.h"
#include "base/failure.h"

namespace sfw {
namespace {

constexpr std::int64_t kScanWindowNs = 500'000'000;

constexpr std::int64_t kOwnReadingsNs = 30'000'000'000;

ros::Time toTime(std::int64_t stamp_ns) {
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(stamp_ns, 0)));
  return time;
}

}  // namespace

ScanLocalisation::ScanLocalisation(const ros::NodeHandle& private_node, const RosSettings& settings,
                                   const tf2_ros::Buffer& transforms)
    : settings_(settings), transforms_(transforms) {
  ros::NodeHandle node = private_node;
  publisher_ = node.advertise<geometry_msgs::PoseWithCovarianceStamped>("localisation", 10);
  thread_ = std::thread([this] { run(); });
}

ScanLocalisation::~ScanLocalisation() {
  stop_ = true;
  wake_.notify_all();
  thread_.join();
}

void ScanLocalisation::add(const std::vector<Observation>& observations) {
  constexpr std::size_t kMostWaiting = 20000;  // more come only while a map is learned
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Observation& observation : observations) {
    const auto* const reading = std::get_if<UnlocatedReading>(&observation.content);
    const bool is_own = observation.robot.empty() || observation.robot == settings_.antenna_frame;
    if (reading != nullptr && is_own && isUsable(observation) && heard_.size() < kMostWaiting) {
      heard_.push_back({static_cast<std::int64_t>(observation.stamp.toNSec()), Position::Zero(),
                        reading->bssid, reading->rssi_dbm});
    }
  }
}

void ScanLocalisation::learnFrom(const Mapper& mapper) {
  constexpr std::size_t kFewestReadings = 50;
  std::vector<Reading> readings = mapper.readings();
  const std::int64_t latest_ns =
      static_cast<std::int64_t>(ros::Time::now().toNSec()) - kOwnReadingsNs;
  readings.erase(std::remove_if(readings.begin(), readings.end(),
                                [&](const Reading& one) { return one.stamp_ns > latest_ns; }),
                 readings.end());
  const std::lock_guard<std::mutex> lock(mutex_);
  if (readings.size() < std::max(kFewestReadings, known_readings_ + known_readings_ / 5)) {
    return;
  }
  known_readings_ = readings.size();
  lesson_ = std::make_unique<Lesson>(Lesson{std::move(readings), mapper.accessPoints()});
}

void ScanLocalisation::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  forget_ = true;
  known_readings_ = 0;
  lesson_ = nullptr;
  heard_.clear();
}

void ScanLocalisation::startAgain() {
  const std::lock_guard<std::mutex> lock(mutex_);
  start_again_ = true;
  heard_.clear();
}

void ScanLocalisation::run() {
  const std::chrono::duration<double> period(1.0 / settings_.localisation_rate_hz);
  while (!stop_) {
    std::unique_ptr<Lesson> lesson;
    std::vector<Reading> heard;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait_for(lock, period, [this] { return stop_.load(); });
      lesson = std::move(lesson_);
      heard.swap(heard_);
      if (forget_) {
        filter_ = nullptr;
        map_ = nullptr;
      }
      if (start_again_ && map_) {
        filter_ = std::make_unique<ParticleFilter>(*map_, ParticleFilter::Config());
      }
      forget_ = start_again_ = false;
    }
    try {
      if (lesson && !stop_) {
        learn(*lesson);
      }
      if (filter_ && !stop_) {
        follow(std::move(heard));
      }
    } catch (const std::exception& error) {
      noteFailure(error);
    }
  }
}

void ScanLocalisation::noteFailure(const std::exception& error) noexcept {
  try {
    ROS_ERROR_STREAM_THROTTLE(60.0, "The localisation failed and goes on: " << reasonOf(error));
  } catch (const std::exception&) {
    // Not even the memory for the text is there; the next failure may be told.
  }
}

void ScanLocalisation::learn(const Lesson& lesson) {
  RadioMap::Config config;
  config.layers.stop = &stop_;
  auto map = std::make_unique<RadioMap>(scansOf(lesson.readings, kScanWindowNs),
                                        lesson.access_points, config);
  if (stop_) {
    return;
  }
  if (!map_) {
    ROS_INFO_STREAM("The localisation starts: it learned "
                    << map->radios().size() << " radios from " << lesson.readings.size()
                    << " readings");
  }
  filter_ = std::make_unique<ParticleFilter>(*map, ParticleFilter::Config());
  map_ = std::move(map);
}

void ScanLocalisation::follow(std::vector<Reading> readings) {
  std::optional<PlaceEstimate> estimate;
  std::int64_t stamp_ns = 0;
  for (const Scan& scan : scansOf(std::move(readings), kScanWindowNs)) {
    const std::optional<Position> odometry = odometryAt(scan.stamp_ns);
    std::optional<Position> step;
    if (odometry && odometry_) {
      step.emplace(*odometry - *odometry_);
    }
    odometry_ = odometry;
    estimate = filter_->add(scan, step);
    stamp_ns = scan.stamp_ns;
  }
  if (estimate) {
    publish(stamp_ns, *estimate);
  }
}

std::optional<Position> ScanLocalisation::odometryAt(std::int64_t stamp_ns) const {
  const std::string frame = settings_.odom_frame.empty() ? "odom" : settings_.odom_frame;
  const ros::Time stamp = toTime(stamp_ns);
  if (frame == settings_.map_frame ||
      !transforms_.canTransform(frame, settings_.antenna_frame, stamp)) {
    return std::nullopt;
  }
  const geometry_msgs::Vector3 antenna =
      transforms_.lookupTransform(frame, settings_.antenna_frame, stamp).transform.translation;
  return Position(antenna.x, antenna.y);
}

void ScanLocalisation::publish(std::int64_t stamp_ns, const PlaceEstimate& estimate) {
  publisher_.publish(toPoseMessage(estimate, toTime(stamp_ns), settings_.map_frame));
}

geometry_msgs::PoseWithCovarianceStamped toPoseMessage(const PlaceEstimate& estimate,
                                                       const ros::Time& stamp,
                                                       const std::string& map_frame) {
  constexpr std::size_t kRow = 6;  // of the covariance: x, y, z, roll, pitch, yaw
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = map_frame;
  message.pose.pose.position.x = estimate.position.x();
  message.pose.pose.position.y = estimate.position.y();
  message.pose.pose.orientation.w = 1.0;
  message.pose.covariance[0] = estimate.covariance(0, 0);
  message.pose.covariance[1] = estimate.covariance(0, 1);
  message.pose.covariance[kRow] = estimate.covariance(1, 0);
  message.pose.covariance[kRow + 1] = estimate.covariance(1, 1);
  message.pose.covariance[kRow * kRow - 1] = kPi * kPi / 3.0;
  return message;
}

}  // namespace sfw
