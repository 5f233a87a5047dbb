#include "ros/mapping/announcements.h"

namespace sfw {

bool Announcements::isNews(const std::string& cause, const std::string& state) {
  constexpr std::size_t kMostCauses = 1000;  // texts with values of hostile messages never end
  const std::lock_guard<std::mutex> lock(mutex_);
  if (states_.size() >= kMostCauses && states_.count(cause) == 0) {
    return false;
  }
  const auto [told, is_first] = states_.emplace(cause, state);
  const bool is_news = is_first || told->second != state;
  told->second = state;
  return is_news;
}

bool Announcements::isNews(const std::string& cause, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t& told = digits_[cause];
  const std::size_t digits = count == 0 ? 0 : std::to_string(count).size();
  if (digits <= told) {
    return false;
  }
  told = digits;
  return true;
}

void Announcements::forget(const std::string& cause) {
  const std::lock_guard<std::mutex> lock(mutex_);
  states_.erase(cause);
  digits_.erase(cause);
}

void Announcements::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  states_.clear();
  digits_.clear();
}

}  // namespace sfw
