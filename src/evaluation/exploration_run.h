#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/drive_command.h"
#include "simulation/building/floor_plan.h"
#include "simulation/radio/noise_level.h"
#include "structure_from_wifi/snapshot.h"
#include "structure_from_wifi/types.h"

namespace sfw {

/// A way to drive through an unknown building.
class ExplorationPolicy {
 public:
  virtual ~ExplorationPolicy() = default;

  /// One step of 0.1 s.
  /// @param pose     as the robot's localisation reports it, map frame
  /// @param touched  the point that the bumper touches [m], map frame
  /// @param now_s    since the start [s]
  virtual DriveCommand step(const RobotPose& pose, const std::optional<Position>& touched,
                            double now_s) = 0;

  /// Whether the policy drives by maps. Then it gets one every ten seconds.
  virtual bool usesMaps() const { return false; }
  virtual void setMap(const Snapshot& /*map*/) {}

  /// Whether somebody drives who sees where the robot is. Then poses have no error.
  virtual bool seesTruth() const { return false; }

  /// Whether it has ended by itself.
  virtual bool finished() const { return false; }
  virtual bool stuck() const { return false; }
};

/// A simulated exploration of a floor plan.
struct ExplorationRunConfig {
  NoiseLevel noise = noiseLevel("realistic");
  std::int64_t seed = 1;
  std::vector<AccessPoint> access_points;
  std::vector<double> report_s = {300.0, 600.0, 1200.0};  ///< times of reports, rising [s]
};

/// What a drive has brought at a time.
struct ExplorationReport {
  double time_s = 0.0;      ///< since the start; earlier than asked if the drive ended before [s]
  double driven_m = 0.0;    ///< [m]
  std::size_t touches = 0;  ///< of obstacles
  bool finished = false;    ///< the policy ended before
  bool stuck = false;       ///< and says that nothing frees the robot
  std::shared_ptr<const Snapshot> map;
};

/// Drives a robot with bumpers by a policy, and maps what it hears on the way.
/// @param start  true pose in the plan
/// @return a report for each time of the configuration
std::vector<ExplorationReport> runExploration(const FloorPlan& plan, const RobotPose& start,
                                              ExplorationPolicy& policy,
                                              const ExplorationRunConfig& config);

}  // namespace sfw
