#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ros/conversion/observation.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"
#include "structure_from_wifi/path_correction.h"

namespace sfw {

/// What was sensed, and where.
struct PlacedObservation {
  std::variant<Reading, std::vector<Contact>> content;
  std::optional<OdometryCorrection> fix;  ///< missing where tf does not know ros/odom_frame
};

/// Places an observation where tf says that it was made. Never waits.
/// @return nothing, with tf's words in `reason`, if there is no transform at its stamp.
std::optional<PlacedObservation> place(const Observation& observation, const Config::Ros& config,
                                       const tf2::BufferCore& transforms, std::string& reason);

/// The last that tf knows of the antenna's place and the odometry's correction.
std::optional<OdometryCorrection> latestFix(const Config::Ros& config,
                                            const tf2::BufferCore& transforms);

/// Puts an observation into a mapper; the anchor gets the fix of what the mapper keeps.
void insert(const PlacedObservation& observation, Mapper& mapper, PathCorrector& anchor);

PathCorrector::Tolerance jumpTolerance(const Config::Ros& config);

/// Observations waiting for the transform at their stamp, in order of arrival.
///
/// The input callbacks push, the mapping thread places: push() never waits for tf, and tf never
/// waits at all, because a lookup with a timeout would hang while simulated time stands still.
/// Thread-safe.
class ObservationQueue {
 public:
  explicit ObservationQueue(const Config::Ros& config) : config_(config) {}

  /// Adds an observation; the oldest one goes if ros/max_waiting is reached.
  void push(Observation observation);

  /// Forgets all that waits, e.g. when time jumps back.
  void clear();

  /// What became of the observations of one call of place().
  struct Outcome {
    std::size_t placed = 0;
    std::size_t expired = 0;      ///< older than ros/transform_timeout, or waited for so long
    std::size_t crowded_out = 0;  ///< pushed out since the last call
    std::string reason;           ///< tf's words for the last one that expired
  };

  /// Takes what has a transform by now.
  using Sink = std::function<void(const PlacedObservation&)>;

  /// Hands on whatever has a transform by now, and drops what is too old or has waited too long, as
  /// a stamp in the future does. Never waits.
  /// @param now the clock of the stamps; zero (not known yet) expires nothing
  Outcome place(const tf2::BufferCore& transforms, const ros::Time& now, const Sink& sink);

 private:
  struct Waiting {
    Observation observation;
    ros::Time since;  // zero before the first attempt to place it
  };

  bool isExpired(const Waiting& waiting, const ros::Time& now) const;

  const Config::Ros config_;
  std::mutex mutex_;
  std::deque<Waiting> waiting_;
  std::size_t crowded_out_ = 0;
};

}  // namespace sfw
