#include "simulation/simulated_recording.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/random_streams.h"
#include "base/validation.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

constexpr double kDriftDistance = 10.0;  // over which drift changes its direction [m]

/// Returns the settings themselves, after their check.
/// @throw InputError
const RecordingConfig& usable(const RecordingConfig& config) {
  throwIfAny(validate(config));
  return config;
}

/// The time of a sample of an access point, which the radio may miss.
struct SampleTime {
  double time_s;
  std::size_t access_point;
  std::uint64_t sample;
};

/// The samples of a drive, by time, then by access point.
std::vector<SampleTime> sampleTimes(std::size_t access_points, double duration_s,
                                    const RecordingConfig& config) {
  const bool scans = config.listening == Listening::kScans;
  const double period_s = scans ? config.scan_period_s : 1.0 / config.link_rate_hz;
  std::vector<SampleTime> times;
  for (std::size_t i = 0; i < access_points; ++i) {
    const double channel =
        1.0 - Random(config.radio.seed, streamOf(Purpose::kChannel, i), 0).uniform();
    const double first_s = scans ? channel * period_s : 0.0;
    for (std::uint64_t sample = 0;; ++sample) {
      const double time_s = first_s + period_s * static_cast<double>(sample);
      if (time_s > duration_s) {
        break;
      }
      times.push_back({time_s, i, sample});
    }
  }
  std::sort(times.begin(), times.end(), [](const SampleTime& a, const SampleTime& b) {
    return a.time_s < b.time_s || (a.time_s == b.time_s && a.access_point < b.access_point);
  });
  return times;
}

}  // namespace

std::vector<std::string> validate(const RecordingConfig& config) {
  Problems problems;
  problems.within("speed", config.speed_m_s, 0.01, 10.0);
  problems.within("yaw_rate", config.yaw_rate_rad_s, 0.01, 100.0);
  problems.within("link_rate", config.link_rate_hz, 0.01, 1000.0);
  problems.within("scan_period", config.scan_period_s, 0.01, 1000.0);
  problems.within("start", config.start_s, 0.0, 9e9);
  problems.within("registration_error", config.registration_error_m, 0.0, 10.0);
  problems.within("registration_distance", config.registration_distance_m, 0.01, 1000.0);
  problems.within("drift", config.drift, 0.0, 1.0);
  problems.add(validate(config.radio), "radio/");
  return problems.list();
}

PositionError::PositionError(const RecordingConfig& config)
    : registration_error_(config.registration_error_m),
      drift_(config.drift),
      registration_x_(RandomField::Kind::kSmooth, config.registration_distance_m, config.radio.seed,
                      streamOf(Purpose::kErrorX)),
      registration_y_(RandomField::Kind::kSmooth, config.registration_distance_m, config.radio.seed,
                      streamOf(Purpose::kErrorY)),
      drift_x_(RandomField::Kind::kSmooth, kDriftDistance, config.radio.seed,
               streamOf(Purpose::kDriftX)),
      drift_y_(RandomField::Kind::kSmooth, kDriftDistance, config.radio.seed,
               streamOf(Purpose::kDriftY)) {}

Position PositionError::registration(const Position& position) const {
  if (registration_error_ == 0.0) {
    return Position::Zero();
  }
  return registration_error_ * Position(registration_x_.at(position), registration_y_.at(position));
}

Position PositionError::drift(double driven_m) const {
  if (drift_ == 0.0) {
    return Position::Zero();
  }
  const Position at(driven_m, 0.0);
  return std::sqrt(0.5) * drift_ * driven_m * Position(drift_x_.at(at), drift_y_.at(at));
}

SimulatedDrive::SimulatedDrive(const std::vector<Position>& way_points,
                               const RecordingConfig& config)
    : route_(way_points, usable(config).speed_m_s, config.yaw_rate_rad_s), error_(config) {}

RobotPose SimulatedDrive::reportedPose(double time_s) const {
  RobotPose pose = route_.poseAt(time_s);
  const Position registration = error_.registration(pose.position);
  const Position drift = error_.drift(route_.drivenAt(time_s));
  pose.position += registration + drift;
  return pose;
}

SimulatedRecording simulateRecording(const FloorPlan& plan, const std::vector<Position>& way_points,
                                     const std::vector<Transmitter>& transmitters,
                                     const RecordingConfig& config) {
  const SimulatedDrive drive(way_points, config);
  const RadioModel radio(plan, transmitters, config.radio);
  SimulatedRecording recording;
  for (const SampleTime& at : sampleTimes(transmitters.size(), drive.duration(), config)) {
    const RobotPose pose = drive.truePose(at.time_s);
    const auto rssi_dbm = radio.rssi(at.access_point, pose, at.sample);
    if (!rssi_dbm) {
      continue;
    }
    Reading reading;
    reading.stamp_ns = std::llround((config.start_s + at.time_s) * 1e9);
    reading.antenna_in_map = drive.reportedPose(at.time_s).position;
    reading.bssid = transmitters[at.access_point].access_point.bssid;
    reading.rssi_dbm = *rssi_dbm;
    recording.readings.push_back(reading);
    recording.truth.push_back(
        {pose, at.access_point, radio.wallCount(at.access_point, pose.position)});
  }
  return recording;
}

}  // namespace sfw
