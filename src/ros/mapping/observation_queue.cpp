#include "ros/mapping/observation_queue.h"

#include <algorithm>
#include <iterator>
#include <utility>

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
  usable_ += is_usable ? 1 : 0;
  waiting_.push_back({std::move(observation), ros::Time()});
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

bool ObservationQueue::isExpired(const Waiting& waiting, const ros::Time& now) const {
  // ros::Duration is not used, because it throws if stamps are 68 years apart.
  const auto is_long_before_now = [&](const ros::Time& time) {
    return now.toSec() - time.toSec() > config_.transform_timeout_s;
  };
  return is_long_before_now(waiting.observation.stamp) ||
         (!waiting.since.isZero() && is_long_before_now(waiting.since));
}

ObservationQueue::Outcome ObservationQueue::locate(const tf2::BufferCore& transforms,
                                                   const ros::Time& now, const Sink& sink) {
  std::deque<Waiting> all;
  Outcome outcome;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    all.swap(waiting_);
    usable_ = 0;
    std::swap(outcome.overflowed, overflowed_);
    std::swap(outcome.unusable, unusable_dropped_);
  }
  std::deque<Waiting> still_waiting;
  const auto giveBack = [&] {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::deque<Waiting>* part : {&all, &still_waiting}) {
      usable_ += static_cast<std::size_t>(
          std::count_if(part->begin(), part->end(),
                        [](const Waiting& waiting) { return isUsable(waiting.observation); }));
      waiting_.insert(waiting_.begin(), std::make_move_iterator(part->begin()),
                      std::make_move_iterator(part->end()));
    }
  };
  while (!all.empty()) {
    Waiting waiting = std::move(all.front());
    all.pop_front();
    std::string tf_error;
    if (auto located = robots_.locate(waiting.observation, transforms, tf_error)) {
      try {
        {
          const std::lock_guard<std::mutex> lock(sampling_);
          robots_.sampleWay(transforms, *located);
        }
        sink(*located);
      } catch (const std::exception&) {
        giveBack();  // the others
        throw;
      }
      ++outcome.located;
    } else if (isExpired(waiting, now)) {
      ++outcome.expired;
      outcome.tf_error = tf_error;
    } else {
      waiting.since = waiting.since.isZero() ? now : waiting.since;
      still_waiting.push_back(std::move(waiting));
    }
  }
  giveBack();
  return outcome;
}

}  // namespace sfw
