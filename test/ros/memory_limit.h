#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>

#include "support/slowdown.h"

namespace sfw {

/// Lets the process allocate little more than it has. Large allocations then really fail.
class MemoryLimit {
 public:
  static bool isPossible() { return kSlowdown == 1.0; }

  /// @param spare  bytes that the process may still get
  explicit MemoryLimit(std::size_t spare) {
    getrlimit(RLIMIT_AS, &before_);
    std::ifstream file("/proc/self/statm");
    std::size_t pages = 0;
    file >> pages;
    rlimit limit = before_;
    limit.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + spare;
    setrlimit(RLIMIT_AS, &limit);
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &before_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit before_{};
};

}  // namespace sfw
