// A mapping nodelet is loaded and unloaded in traffic, again and again.

#include <gtest/gtest.h>
#include <malloc.h>
#include <nav_msgs/GetMap.h>
#include <std_srvs/Trigger.h>
#include <sys/resource.h>

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
  constexpr std::ptrdiff_t kPool =
      3;  // connections to the master that roscpp keeps for half a minute
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

TEST_F(NodeletLifeTest, ServicesInTrafficServeWholeMaps) {
  const double seconds = kSlowdown >= 10.0 ? 60.0 : 5.0;  // with the thread sanitizer
  load();
  startTraffic();
  ASSERT_TRUE(mapsSomething());
  const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(seconds);
  std::atomic<int> resets{0}, saves{0};
  const auto untilTheEnd = [&](const std::function<void()>& call) {
    return std::thread([&end, call] {
      while (ros::SteadyTime::now() < end) {
        call();
      }
    });
  };
  std::thread saving = untilTheEnd([&] {
    structure_from_wifi::SaveMap call;
    call.request.directory = "saved";
    EXPECT_TRUE(ros::service::call(name_ + "/mapping/save_map", call));
    saves += call.response.success ? 1 : 0;
  });
  std::thread resetting = untilTheEnd([&] {
    std_srvs::Trigger call;
    EXPECT_TRUE(ros::service::call(name_ + "/mapping/reset", call));
    resets += call.response.success ? 1 : 0;
    ros::WallDuration(0.3).sleep();
  });
  StaticLayer served;
  while (ros::SteadyTime::now() < end) {
    nav_msgs::GetMap call;
    EXPECT_TRUE(ros::service::call(name_ + "/dynamic_map", call));
    EXPECT_TRUE(served.accept(call.response.map));
    ros::spinOnce();  // the layer of this world takes the published ones
  }
  saving.join();
  resetting.join();
  EXPECT_GT(served.maps(), 10U);
  EXPECT_GT(resets, 2);
  EXPECT_GT(saves, 0);
  EXPECT_LT(secondsToUnload(), 1.0 * kSlowdown);
}

/// User and system time of this process [s].
double cpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

TEST_F(NodeletLifeTest, FiftyAccessPointsTenTimesASecondTakeLessThanACore) {
  if (kSlowdown > 1.0) {
    GTEST_SKIP() << "a sanitizer takes several times the processor's time";
  }
  std::vector<std::tuple<std::string, double, double>> table;
  Readings scan;
  for (int i = 0; i < 50; ++i) {
    char bssid[18];
    std::snprintf(bssid, sizeof bssid, "02:00:00:00:01:%02x", i);
    table.emplace_back(bssid, 2.0 + 5.0 * (i % 10), 2.0 + 11.0 * (i / 10));
    scan.emplace_back(bssid, -50.0F - static_cast<float>(i % 30));
  }
  ros::param::set(name_ + "/mapping/access_points", tableOf(table));
  ros::param::set(name_ + "/mapping/map/growth_step", 50.0);  // 1000 x 1000 cells
  ros::param::set(name_ + "/mapping/ros/publish_rate", 1.0);
  load();
  ASSERT_TRUE(spinUntil([&] { return map_ != nullptr; }, 30.0));
  EXPECT_EQ(map_->info.width, 1000U);
  EXPECT_EQ(map_->info.height, 1000U);
  constexpr double kSeconds = 20.0;
  const double cpu_s = cpuSeconds();
  const ros::SteadyTime start = ros::SteadyTime::now();
  for (int i = 0; (ros::SteadyTime::now() - start).toSec() < kSeconds; ++i) {
    ros::Time::setNow(at(0.1 * i));
    sendPose(0.1 * i, 1.0 + 0.03 * i, 1.0 + 5.0 * ((i / 100) % 2));
    sendScan(0.1 * i, scan);
    spinUntil([&] { return (ros::SteadyTime::now() - start).toSec() > 0.1 * (i + 1); }, 0.1);
  }
  const double share = (cpuSeconds() - cpu_s) / (ros::SteadyTime::now() - start).toSec();
  RecordProperty("percent_of_a_core", static_cast<int>(100.0 * share));
  EXPECT_LT(share, 1.0);
  EXPECT_TRUE(
      spinUntil([&] { return std::count(map_->data.begin(), map_->data.end(), 0) > 100; }, 30.0));
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_life_test");
  const ros::NodeHandle node;  // keeps ROS up between the tests
  return RUN_ALL_TESTS();
}
