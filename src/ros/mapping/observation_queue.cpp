#include "ros/mapping/observation_queue.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>
#include <variant>

namespace sfw {

void ObservationQueue::push(std::vector<Observation> message) {
  const std::size_t most = std::max(static_cast<std::size_t>(config_.max_waiting), message.size());
  const std::lock_guard<std::mutex> lock(mutex_);
  for (Observation& observation : message) {
    push(std::move(observation), most);
  }
}

void ObservationQueue::push(Observation observation, std::size_t most_usable) {
  const bool is_usable = isUsable(observation);
  const auto most_unusable =
      static_cast<std::size_t>(std::max<std::int64_t>(1, config_.max_waiting / 10));
  if (!is_usable && waiting_.size() - usable_ >= most_unusable) {
    ++unusable_dropped_;
    return;
  }
  if (is_usable && usable_ >= most_usable) {
    dropOldest();
  }
  waiting_.push_back({std::move(observation), ros::Time()});
  usable_ += is_usable ? 1 : 0;
}

void ObservationQueue::dropOldest() {
  bool is_usable = false;
  while (!is_usable && !waiting_.empty()) {
    is_usable = isUsable(waiting_.front().observation);
    waiting_.pop_front();
    ++(is_usable ? overflowed_ : unusable_dropped_);
  }
  usable_ -= is_usable ? 1 : 0;
}

void ObservationQueue::clear() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.clear();
    usable_ = 0;
  }
  const std::lock_guard<std::mutex> lock(sampling_);
  robots_.forgetWays();
}

std::size_t ObservationQueue::size() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.size();
}

std::size_t ObservationQueue::readings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(waiting_.begin(), waiting_.end(), [](const Waiting& waiting) {
        return std::holds_alternative<UnlocatedReading>(waiting.observation.content);
      }));
}

bool ObservationQueue::isExpired(const Waiting& waiting, const ros::Time& now) const {
  // ros::Duration is not used, because it throws if stamps are 68 years apart.
  const auto is_long_before_now = [&](const ros::Time& time) {
    return now.toSec() - time.toSec() > config_.transform_timeout_s;
  };
  return is_long_before_now(waiting.observation.stamp) ||
         (!waiting.since.isZero() && is_long_before_now(waiting.since));
}

void ObservationQueue::giveBack(std::list<Waiting>& observations) {
  usable_ += static_cast<std::size_t>(
      std::count_if(observations.begin(), observations.end(),
                    [](const Waiting& waiting) { return isUsable(waiting.observation); }));
  waiting_.splice(waiting_.begin(), observations);
}

ObservationQueue::Outcome ObservationQueue::locate(const tf2::BufferCore& transforms,
                                                   const ros::Time& now, const Sink& sink) {
  std::list<Waiting> all, still_waiting;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    all.swap(waiting_);
    usable_ = 0;
  }
  Outcome outcome;
  try {
    while (!all.empty()) {
      locateFirst(all, still_waiting, transforms, now, sink, outcome);
    }
  } catch (const std::exception&) {
    const std::lock_guard<std::mutex> lock(mutex_);
    giveBack(all);
    giveBack(still_waiting);
    throw;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  giveBack(still_waiting);
  std::swap(outcome.overflowed, overflowed_);
  std::swap(outcome.unusable, unusable_dropped_);
  return outcome;
}

void ObservationQueue::locateFirst(std::list<Waiting>& all, std::list<Waiting>& still_waiting,
                                   const tf2::BufferCore& transforms, const ros::Time& now,
                                   const Sink& sink, Outcome& outcome) {
  std::list<Waiting> first;
  first.splice(first.begin(), all, all.begin());
  Waiting& waiting = first.front();
  std::string tf_error;
  try {
    if (auto located = robots_.locate(waiting.observation, transforms, tf_error)) {
      {
        const std::lock_guard<std::mutex> lock(sampling_);
        robots_.sampleWay(transforms, *located);
      }
      sink(*located);
      ++outcome.located;
      return;
    }
  } catch (const std::bad_alloc&) {
    all.splice(all.begin(), first);  // memory may come back
    throw;
  }
  if (isExpired(waiting, now)) {
    const auto* contacts = std::get_if<UnlocatedContacts>(&waiting.observation.content);
    if (contacts == nullptr) {
      ++outcome.expired;
      outcome.tf_error = tf_error;
    } else {
      ++outcome.expired_contacts;
      outcome.contacts_frame = contacts->frame;
      outcome.contacts_tf_error = tf_error;
    }
    return;
  }
  waiting.since = waiting.since.isZero() ? now : waiting.since;
  still_waiting.splice(still_waiting.end(), first);
}

}  // namespace sfw
