#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>

#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <vector>

#include "ros/conversion/ros_settings.h"
#include "ros/mapping/localization.h"
#include "ros/mapping/robots.h"

namespace sfw {

/// Holds observations, in order of arrival, until tf has the transform at their stamp.
///
/// Input callbacks push; the locating thread calls locate(), and so does the mapping thread before
/// it saves a map. Neither function waits for tf: a look-up with a timeout would hang while
/// simulated time stands still. Thread-safe.
class ObservationQueue {
 public:
  explicit ObservationQueue(const RosSettings& config) : config_(config), robots_(config) {}

  /// Adds the observations of a message. With ros/max_waiting usable ones in the queue, the oldest
  /// is dropped, but none of the message itself. A tenth as many unusable ones may wait beside
  /// them, and take no place of a usable one.
  void push(std::vector<Observation> message);

  /// Drops all observations, and forgets which part of the path was sampled.
  void clear();

  /// The number of observations that wait.
  std::size_t size() const;

  /// The number of readings among them.
  std::size_t readings() const;

  /// Counts the observations of one call of locate().
  struct Outcome {
    std::size_t located = 0;
    std::size_t expired = 0;  ///< readings older than ros/transform_timeout, or so long here
    std::size_t expired_contacts = 0;  ///< contacts likewise
    std::size_t overflowed = 0;        ///< usable ones dropped by push() since the last call
    std::size_t unusable = 0;          ///< unusable ones likewise
    std::string tf_error;              ///< of the last reading that expired
    std::string contacts_frame;        ///< of the last contacts that expired
    std::string contacts_tf_error;     ///< likewise
  };

  using Sink = std::function<void(const LocatedObservation&)>;

  /// Passes on each observation that tf can locate, with the way driven since the ones before.
  /// Drops observations that are too old or have waited too long. An observation with a stamp in
  /// the future waits until it is dropped.
  /// If the sink throws, its observation is dropped and the others wait on. Without memory
  /// (std::bad_alloc) its observation waits, too.
  /// @param now  of the clock of the stamps; with zero, an unknown time, nothing expires
  Outcome locate(const tf2::BufferCore& transforms, const ros::Time& now, const Sink& sink);

 private:
  struct Waiting {
    Observation observation;
    ros::Time since;  // zero before the first attempt to locate it
  };

  void push(Observation observation, std::size_t most_usable);

  /// Drops the oldest usable observation, and with it the unusable ones before it.
  void dropOldest();

  /// Puts observations back before those that wait; mutex_ is held.
  void giveBack(std::list<Waiting>& observations);

  /// Passes on the first one of all, drops it, or lets it wait.
  void locateFirst(std::list<Waiting>& all, std::list<Waiting>& still_waiting,
                   const tf2::BufferCore& transforms, const ros::Time& now, const Sink& sink,
                   Outcome& outcome);

  bool isExpired(const Waiting& waiting, const ros::Time& now) const;

  const RosSettings config_;
  mutable std::mutex mutex_;
  std::list<Waiting> waiting_;  // its items move without memory
  std::size_t usable_ = 0;      // of those that wait
  std::size_t overflowed_ = 0;
  std::size_t unusable_dropped_ = 0;
  std::mutex sampling_;  // around the next member, so that push() never waits for it
  Robots robots_;
};

}  // namespace sfw
