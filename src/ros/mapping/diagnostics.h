#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <tf2/buffer_core.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros/conversion/ros_settings.h"
#include "ros/mapping/input_statistics.h"
#include "structure_from_wifi/data_checks.h"
#include "structure_from_wifi/snapshot.h"

namespace sfw {

/// The transform from the antenna to the map, as tf has it now.
struct TransformStatus {
  std::string map_frame, antenna_frame;
  std::vector<std::string> missing_frames;  ///< of the two, those that tf does not know
  std::string tf_error;                     ///< in tf's words; empty if there is a transform
  double age_s = 0.0;                       ///< of the latest transform
  std::string odom_frame = {};              ///< as odometryFrame
};

/// Looks at the latest transform. Never waits, never throws.
/// @param now  of the clock of the stamps
TransformStatus transformStatus(const RosSettings& config, const tf2::BufferCore& transforms,
                                const ros::Time& now);

/// Everything that diagnostics tell about a mapping nodelet.
struct MappingStatus {
  std::string failure;            ///< why it cannot map at all, a problem a line; empty if it can
  std::string update_failure;     ///< why the last map update failed; empty if it did not
  std::string autosave_failure;   ///< why the session was not saved last time; empty if it was
  bool is_clock_missing = false;  ///< /use_sim_time is set, and no /clock came
  bool is_paused = false;
  double now_s = 0.0;      ///< of the clock of InputStatistics
  double running_s = 0.0;  ///< since the start
  std::vector<InputStatistics::Input> inputs;
  TransformStatus transform;
  FrameFinding frames;                  ///< what is wrong with transforms
  std::size_t infinite_transforms = 0;  ///< left out
  double transform_timeout_s = 0.0;
  std::size_t waiting = 0;              ///< readings that wait for a transform
  std::size_t expired = 0;              ///< readings dropped without a transform
  std::size_t expired_contacts = 0;     ///< contacts likewise
  std::size_t overflowed = 0;           ///< readings dropped because too many waited
  std::size_t tilted = 0;               ///< readings of a tilted antenna
  std::size_t jumped = 0;               ///< readings dropped for their speed
  std::size_t readings = 0;             ///< kept by the mapper
  Rejections rejections;                ///< of the mapper
  std::shared_ptr<const Snapshot> map;  ///< last one, or nullptr
  DataFindings findings;                ///< of its checks
  double free_m2 = 0.0;                 ///< its free area
  double inference_s = 0.0;             ///< time that the last map took
};

/// Describes the inputs, the transforms or the map: level, a sentence, and values.
/// @{
void describeInputs(const MappingStatus& status, diagnostic_updater::DiagnosticStatusWrapper& to);
void describeTransforms(const MappingStatus& status,
                        diagnostic_updater::DiagnosticStatusWrapper& to);
void describeMap(const MappingStatus& status, diagnostic_updater::DiagnosticStatusWrapper& to);
/// @}

/// Why there are no readings, as a sentence; empty if there is no reason.
std::string whyNoReading(const MappingStatus& status);

}  // namespace sfw
