// A mapping nodelet is loaded and unloaded in traffic, again and again.

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iterator>
#include <thread>

#include "mapping_nodelet_world.h"
#include "support/slowdown.h"

namespace sfw {
namespace {

/// What a process holds.
struct Holdings {
  std::ptrdiff_t descriptors = 0, threads = 0;
  double heap_kib = 0.0;

  static std::ptrdiff_t entries(const char* folder) {
    const std::filesystem::directory_iterator all(folder);
    return std::distance(begin(all), end(all));
  }

  static Holdings most(const Holdings& a, const Holdings& b) {
    return {std::max(a.descriptors, b.descriptors), std::max(a.threads, b.threads),
            std::max(a.heap_kib, b.heap_kib)};
  }

  static Holdings now() {
    const struct mallinfo2 heap = mallinfo2();
    return {entries("/proc/self/fd"), entries("/proc/self/task"),
            static_cast<double>(heap.uordblks + heap.hblkhd) / 1024.0};
  }
};

class NodeletLifeTest : public NodeletWorld {
 protected:
  void TearDown() override {
    done_ = true;
    if (traffic_.joinable()) {
      traffic_.join();
    }
    NodeletWorld::TearDown();
  }

  /// Scans and poses that go on while the nodelet comes and goes.
  void startTraffic() {
    traffic_ = std::thread([this] {
      for (int i = 0; !done_; ++i) {
        sendPose(0.005 * i, 0.0005 * (i % 2000), 0.0);
        sendScan(0.005 * i, {{kNear, -50.0F - static_cast<float>(i % 20)}, {kFar, -60.0F}});
        ros::WallDuration(0.005).sleep();
      }
    });
  }

  bool mapsSomething() {
    map_.reset();
    return spinUntil(
        [&] { return map_ && std::count(map_->data.begin(), map_->data.end(), 0) > 0; },
        30.0 * kSlowdown);
  }

  /// Waits until a value is as low as it was; threads and sockets end a little later.
  static bool returnsTo(std::ptrdiff_t most, const std::function<std::ptrdiff_t()>& value) {
    return spinUntil([&] { return value() <= most; }, 10.0);
  }

 private:
  std::atomic<bool> done_{false};
  std::thread traffic_;
};

TEST_F(NodeletLifeTest, AHundredLivesInTrafficLeaveNothingBehind) {
  const int lives = kSlowdown > 1.0 ? 10 : 100;
  constexpr int kWarmUp = 10;  // caches of roscpp and of the C library fill
  startTraffic();
  Holdings before;
  double longest_s = 0.0;
  for (int i = 0; i < lives + kWarmUp; ++i) {
    load();  // the first messages come before it is ready
    if (i % 10 == 0) {
      ASSERT_TRUE(mapsSomething()) << "life " << i;
    }
    longest_s = std::max(longest_s, secondsToUnload());
    if (i < kWarmUp) {
      before = Holdings::most(before, Holdings::now());
    }
  }
  EXPECT_LT(longest_s, 1.0 * kSlowdown);
  constexpr std::ptrdiff_t kPool = 3;  // connections to the master, which roscpp keeps a while
  EXPECT_TRUE(returnsTo(before.descriptors + kPool, [] { return Holdings::now().descriptors; }))
      << Holdings::now().descriptors << " descriptors, " << before.descriptors << " before";
  EXPECT_TRUE(returnsTo(before.threads, [] { return Holdings::now().threads; }))
      << Holdings::now().threads << " threads, " << before.threads << " before";
  const double growth_kib = (Holdings::now().heap_kib - before.heap_kib) / lives;
  RecordProperty("bytes_a_life", static_cast<int>(1024.0 * growth_kib));
  RecordProperty("milliseconds_to_unload", static_cast<int>(1000.0 * longest_s));
  if (kSlowdown == 1.0) {  // a sanitizer has an allocator of its own
    EXPECT_LT(growth_kib, 10.0) << "of the heap, a life";
  }
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_life_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
