#include "evaluation/exploration_run.h"

#include <cmath>
#include <cstddef>

#include "simulation/radio/radio_model.h"
#include "simulation/robot/simulated_robot.h"
#include "simulation/simulated_recording.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {
namespace {

constexpr double kStep = 0.1;            // of the simulation [s]
constexpr std::int64_t kMapSteps = 100;  // between two maps
constexpr std::int64_t kRadioSteps = 2;  // between two samples of each access point

/// The world of one run: the robot, its radio, its localisation and its mapper.
class World {
 public:
  World(const FloorPlan& plan, const RobotPose& start, const ExplorationRunConfig& config)
      : recording_(recordingConfig(config.noise, config.seed)),
        error_(recording_),
        radio_(plan, asTransmitters(config.access_points), recording_.radio),
        robot_(toStates(plan), start, robotConfig()),
        mapper_(Config(), config.access_points) {}

  const RobotPose& truePose() const { return robot_.pose(); }

  RobotPose reportedPose() const {
    RobotPose pose = robot_.pose();
    pose.position += error_.registration(pose.position);
    return pose;
  }

  std::optional<Position> touched() const {
    std::optional<Position> point = robot_.contact();
    if (point) {
      *point += error_.registration(robot_.pose().position);
    }
    return point;
  }

  void listen(std::int64_t step) {
    const std::int64_t stamp = stampOf(step);
    const RobotPose pose = reportedPose();
    for (std::size_t i = 0; i < radio_.transmitters().size(); ++i) {
      const auto rssi = radio_.rssi(i, robot_.pose(), static_cast<std::uint64_t>(step));
      if (rssi) {
        mapper_.insert(
            Reading{stamp, pose.position, radio_.transmitters()[i].access_point.bssid, *rssi});
      }
    }
  }

  void touch(std::int64_t step, const Position& point) {
    mapper_.insert(Contact{stampOf(step), point});
  }

  void drive(const DriveCommand& command) {
    robot_.command(command);
    robot_.step(kStep);
  }

  double driven() const { return robot_.drivenDistance(); }
  std::shared_ptr<const Snapshot> map() const { return mapper_.infer(); }

 private:
  static SimulatedRobot::Config robotConfig() {
    SimulatedRobot::Config config;
    config.command_timeout_s = 0.0;
    return config;
  }

  std::int64_t stampOf(std::int64_t step) const {
    return std::llround((recording_.start_s + kStep * static_cast<double>(step)) * 1e9);
  }

  RecordingConfig recording_;
  PositionError error_;
  RadioModel radio_;
  SimulatedRobot robot_;
  Mapper mapper_;
};

}  // namespace

std::vector<ExplorationReport> runExploration(const FloorPlan& plan, const RobotPose& start,
                                              ExplorationPolicy& policy,
                                              const ExplorationRunConfig& config) {
  World world(plan, start, config);
  std::vector<ExplorationReport> reports;
  std::size_t touches = 0;
  bool in_touch = false;
  for (std::int64_t step = 0; reports.size() < config.report_s.size(); ++step) {
    const double now = kStep * static_cast<double>(step);
    if (step % kRadioSteps == 0) {
      world.listen(step);
    }
    const std::optional<Position> touched = world.touched();
    if (touched && !in_touch) {
      world.touch(step, *touched);
      ++touches;
    }
    in_touch = touched.has_value();
    if (policy.finished() || now >= config.report_s[reports.size()]) {
      ExplorationReport report{
          now, world.driven(), touches, policy.finished(), policy.stuck(), world.map()};
      do {
        reports.push_back(report);
      } while (policy.finished() && reports.size() < config.report_s.size());
    }
    if (policy.usesMaps() && step % kMapSteps == 0) {
      policy.setMap(*world.map());
    }
    world.drive(
        policy.step(policy.seesTruth() ? world.truePose() : world.reportedPose(), touched, now));
  }
  return reports;
}

}  // namespace sfw
