#include "ros/mapping/input_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sfw {

std::size_t InputStatistics::add(const std::string& topic, bool is_radio) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Input input;
  input.topic = topic;
  input.is_radio = is_radio;
  inputs_.push_back(input);
  recent_.emplace_back();
  return inputs_.size() - 1;
}

void InputStatistics::Recent::moveTo(std::int64_t second) {
  const std::int64_t first_new = std::max(last_second + 1, second - kWindow + 1);
  for (std::int64_t s = first_new; s <= second; ++s) {
    counts[static_cast<std::size_t>(s % kWindow)] = 0;
  }
  last_second = std::max(last_second, second);
}

void InputStatistics::count(std::size_t input, const Conversion& conversion, double now_s) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Input& counts = inputs_.at(input);
  ++counts.messages;
  counts.observations += conversion.observations.size();
  counts.problem = conversion.problem;
  counts.last_message_s = now_s;
  if (!conversion.observations.empty()) {
    counts.last_observation_s = now_s;
  }
  for (const auto& [given, count] : conversion.rejected) {
    // Reasons with values of hostile messages never end.
    constexpr std::size_t kMostReasons = 100;
    const bool has_room = counts.rejected.size() < kMostReasons || counts.rejected.count(given) > 0;
    const std::string reason = has_room ? given : "other reasons";
    counts.rejected[reason] += count;
    rejected_[reason] += count;
  }
  const auto second = static_cast<std::int64_t>(std::floor(now_s));
  recent_[input].moveTo(second);
  ++recent_[input].counts[static_cast<std::size_t>(second % kWindow)];
}

std::vector<InputStatistics::Input> InputStatistics::inputs(double now_s) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Input> inputs = inputs_;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    Recent recent = recent_[i];
    recent.moveTo(static_cast<std::int64_t>(std::floor(now_s)));
    inputs[i].rate_hz = static_cast<double>(std::accumulate(recent.counts.begin(),
                                                            recent.counts.end(), std::size_t{0})) /
                        static_cast<double>(kWindow);
  }
  return inputs;
}

std::map<std::string, std::size_t> InputStatistics::takeRejected() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::map<std::string, std::size_t> taken;
  taken.swap(rejected_);
  return taken;
}

}  // namespace sfw
