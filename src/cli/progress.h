#pragma once

#include <chrono>
#include <cstddef>

namespace sfw {

/// On standard error, a bar with the time that is left if that is a terminal, else a line for each
/// tenth.
class Progress {
 public:
  explicit Progress(std::size_t all);

  /// One more is done; `at_once` if it took no time, being there already.
  void add(bool at_once = false);

 private:
  void show() const;

  const std::size_t all_;
  const bool shown_;
  const std::chrono::steady_clock::time_point start_;
  std::size_t done_ = 0;
  std::size_t at_once_ = 0;
};

}  // namespace sfw
