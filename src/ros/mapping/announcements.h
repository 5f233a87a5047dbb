#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

namespace sfw {

/// Decides which log texts are news: each cause is told once, and again when its state changes.
/// Thread-safe.
class Announcements {
 public:
  /// Whether the state of a cause differs from the last one told. It counts as told from now on.
  bool isNews(const std::string& cause, const std::string& state = "");

  /// Whether a count reached another power of ten since it was last told. A reset of the count is
  /// no news.
  bool isNews(const std::string& cause, std::size_t count);

  /// A cause is over: it is news when it comes again.
  void forget(const std::string& cause);

  /// Every cause is over.
  void clear();

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> states_;
  std::map<std::string, std::size_t> digits_;  // of the largest count told
};

}  // namespace sfw
