#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace sfw {

/// Calls `work(i)` once for each i below `count`, on several threads and in no fixed order.
///
/// If a call throws, no further ones begin, and the first exception is thrown again once all
/// threads have ended.
template <class Work>
void parallelFor(std::size_t count, std::int64_t workers, Work&& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto run = [&] {
    for (std::size_t i = next++; i < count && !stop; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        thrown = thrown ? thrown : std::current_exception();
        stop = true;
      }
    }
  };
  std::vector<std::thread> threads;
  for (std::int64_t i = 0; i < workers; ++i) {
    threads.emplace_back(run);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  if (thrown) {
    std::rethrow_exception(thrown);
  }
}

}  // namespace sfw
