#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace sfw {

/// Lets allocations fail: large ones, or one of this thread.
///
/// It replaces the allocation of the whole program, so only one file may include it.
class FailingAllocations {
 public:
  static constexpr int kFollowing = 20;
  enum class Threads {
    kAll,
    kOthers  ///< all but the one that makes this object
  };

  /// @param too_large      bytes of an allocation that fails
  /// @param without_texts  failures after which the next kFollowing allocations of their thread
  /// fail
  ///     too, however small: those for the text of the error
  FailingAllocations(std::size_t too_large, Threads threads, int without_texts = 0) {
    is_exempt_ = threads == Threads::kOthers;
    failures_ = 0;
    without_texts_ = without_texts;
    too_large_ = too_large;
  }
  /// Only the n-th allocation of this thread fails.
  static FailingAllocations ofNth(int n) {
    countdown_ = n;
    return FailingAllocations(SIZE_MAX, Threads::kAll);
  }
  ~FailingAllocations() {
    countdown_ = 0;
    too_large_ = SIZE_MAX;
    is_exempt_ = false;
  }
  FailingAllocations(const FailingAllocations&) = delete;
  FailingAllocations& operator=(const FailingAllocations&) = delete;

  int failures() const { return failures_; }

  static bool fails(std::size_t size) {
    if (countdown_ > 0 && --countdown_ == 0) {
      return true;
    }
    const std::size_t too_large = too_large_;
    if (too_large == SIZE_MAX || is_exempt_) {
      following_ = 0;
      return false;
    }
    if (size >= too_large) {
      following_ = --without_texts_ >= 0 ? kFollowing : 0;
    } else if (following_ == 0) {
      return false;
    } else {
      --following_;
    }
    ++failures_;
    return true;
  }

 private:
  static inline std::atomic<std::size_t> too_large_{SIZE_MAX};
  static inline std::atomic<int> failures_{0}, without_texts_{0};
  static inline thread_local bool is_exempt_ = false;
  static inline thread_local int following_ = 0, countdown_ = 0;
};

}  // namespace sfw

#if !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const memory = sfw::FailingAllocations::fails(size) ? nullptr : std::malloc(size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif
