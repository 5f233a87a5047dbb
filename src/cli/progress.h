#pragma once

#include <chrono>
#include <cstddef>

namespace sfw {

/// Shows progress on standard error: a bar with the remaining time on a terminal, otherwise a line
/// for each tenth.
class Progress {
 public:
  explicit Progress(std::size_t all);

  /// Counts one more item as done. `at_once` means that its result existed already and took no
  /// time.
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
