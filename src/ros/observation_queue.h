#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <cstddef>
#include <deque>
#include <mutex>
#include <string>

#include "observation.h"
#include "structure_from_wifi/config.h"
#include "structure_from_wifi/mapper.h"

namespace sfw {

/// Puts an observation into the mapper where tf says that it was made. Never waits.
/// @return false, with tf's words in `reason`, if there is no transform at its stamp.
bool place(const Observation& observation, const Config::Ros& config,
           const tf2::BufferCore& transforms, Mapper& mapper, std::string& reason);

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

  /// Puts into the mapper whatever has a transform by now, and drops what is too old or has waited
  /// too long, as a stamp in the future does. Never waits.
  /// @param now the clock of the stamps; zero (not known yet) expires nothing
  Outcome place(const tf2::BufferCore& transforms, const ros::Time& now, Mapper& mapper);

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
